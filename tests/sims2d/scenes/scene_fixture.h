#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "sims2d/scenes/rain.h"
#include "sims2d/scenes/scenes.h"

namespace kerf {

/// GoogleTest names the parameter of a failed test by this.
inline std::ostream& operator<<(std::ostream& out, const SceneEntry<2>& entry) { return out << entry.name; }

}  // namespace kerf

namespace kerf::test {

/// A test of 2D scenes.
class Scenes2d : public ::testing::TestWithParam<SceneEntry<2>> {
 protected:
  static std::unique_ptr<Scene<2>> make(BroadPhase<2>& broad_phase, const SceneOptions& options) {
    return GetParam().make(broad_phase, options);
  }
  static const Box2dWorld& world_of(const Scene<2>& scene) {
    return dynamic_cast<const RainScene&>(scene).world();
  }
};

/// Those in which objects rain into a yard.
inline std::vector<SceneEntry<2>> rain_scenes() {
  std::vector<SceneEntry<2>> scenes;
  for (const SceneEntry<2>& entry : scenes_2d())
    if (entry.grows) scenes.push_back(entry);
  return scenes;
}

inline std::string scene_name(const ::testing::TestParamInfo<SceneEntry<2>>& info) {
  return std::string(info.param.name);
}

}  // namespace kerf::test
