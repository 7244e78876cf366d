#include "frames/report/take.h"

#include <string>
#include <variant>

#include "core/bsp/bsp.h"
#include "frames/catalog/scene_catalog.h"
#include "frames/support/errors.h"

namespace kerf {
namespace {

template <int D>
std::vector<Pose<D>> poses_of(const Scene<D>& scene) {
  std::vector<Pose<D>> poses;
  for (const Body<D>& body : scene.bodies()) poses.push_back(body.pose);
  return poses;
}

}  // namespace

template <int D>
const SceneEntry<D>& scene_entry(std::string_view name) {
  const CatalogScene scene = find_scene(std::string(name) + (D == 2 ? "-2d" : "-3d"));
  return *std::get<const SceneEntry<D>*>(scene.entry);
}

template <int D>
Take<D> record(std::string_view scene, const SceneLength& length, const Poll& poll) {
  Bsp<D> broad_phase(tuned_config());
  const SceneOptions options{.objects = length.objects, .steps = length.grow, .recycle = 2};
  const auto world = scene_entry<D>(scene).make(broad_phase, options);
  Take<D> take;
  for (std::uint32_t step = 0; step < length.grow + length.steps; ++step) {
    poll();
    world->advance();
    if (step >= length.grow) take.poses.push_back(poses_of(*world));
  }
  for (const Body<D>& body : world->bodies()) {
    take.shapes.push_back(body.shape);
    take.mobility.push_back(body.mobility);
  }
  return take;
}

template const SceneEntry<2>& scene_entry<2>(std::string_view);
template const SceneEntry<3>& scene_entry<3>(std::string_view);
template Take<2> record<2>(std::string_view, const SceneLength&, const Poll&);
template Take<3> record<3>(std::string_view, const SceneLength&, const Poll&);

}  // namespace kerf
