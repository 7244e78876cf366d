#include "frames/catalog/scene_catalog.h"

#include <algorithm>

#include "frames/support/errors.h"
#include "frames/support/suggest.h"
#include "sims2d/scenes/scenes.h"
#include "sims3d/scenes/scenes.h"

namespace kerf {

std::vector<CatalogScene> scene_catalog() {
  std::vector<CatalogScene> catalog;
  for (const SceneEntry<3>& entry : scenes_3d()) catalog.push_back({std::string(entry.name), &entry});
  for (const SceneEntry<2>& entry : scenes_2d()) {
    const auto same = [&](const SceneEntry<3>& other) { return other.name == entry.name; };
    const bool both = std::ranges::any_of(scenes_3d(), same);
    catalog.push_back({std::string(entry.name) + (both ? "-2d" : ""), &entry});
  }
  return catalog;
}

CatalogScene find_scene(std::string_view name) {
  std::vector<std::string> names;
  for (const CatalogScene& scene : scene_catalog()) {
    const std::string suffix = "-" + std::to_string(scene.dimension()) + "d";
    if (scene.name == name || scene.name + suffix == name) return scene;
    names.push_back(scene.name);
  }
  throw UsageError(unknown_name_message("scene", name, names));
}

void check_grows(const CatalogScene& scene, std::string_view option) {
  if (std::visit([](const auto* entry) { return entry->grows; }, scene.entry)) return;
  throw UsageError(std::string(option) + ": " + scene.name +
                   " does not grow: all its objects are there from the first step; leave the option out");
}

}  // namespace kerf
