#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/scene/scene.h"

namespace kerf {

/// A scene of either dimension under its name in the program. A name that both dimensions use is the 3D
/// scene; the 2D one is then called NAME-2d.
struct CatalogScene {
  std::string name;
  std::variant<const SceneEntry<2>*, const SceneEntry<3>*> entry;

  [[nodiscard]] int dimension() const { return entry.index() == 0 ? 2 : 3; }
};

/// All scenes, 3D first, each room's in its own order.
std::vector<CatalogScene> scene_catalog();

/// The scene called `name`; NAME-2d and NAME-3d work for every scene. Throws UsageError with the nearest name
/// and all valid ones.
CatalogScene find_scene(std::string_view name);

/// Throws UsageError, which begins with the name of the option, if the scene does not grow.
void check_grows(const CatalogScene& scene, std::string_view option);

}  // namespace kerf
