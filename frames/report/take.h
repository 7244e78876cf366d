#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "core/scene/scene.h"
#include "frames/page/cell.h"

namespace kerf {

/// What was recorded of a scene: the shapes of its bodies and where they were in each step. Whatever is
/// measured on it sees the same motion.
template <int D>
struct Take {
  std::vector<Shape<D>> shapes;
  std::vector<Mobility> mobility;
  std::vector<std::vector<Pose<D>>> poses;  ///< by step, then by body
};

/// How long a scene is run: objects come during the first `grow` steps; then `steps` are of interest.
struct SceneLength {
  std::uint32_t objects = 0;
  std::uint32_t grow = 0;
  std::uint32_t steps = 0;
};

/// Runs the scene with the exact broad phase; of heaps, one object falls anew in each second step. Throws
/// UsageError for a scene that D dimensions do not have or that cannot be so large.
template <int D>
Take<D> record(std::string_view scene, const SceneLength& length, const Poll& poll);

/// The scene of that name in D dimensions.
template <int D>
const SceneEntry<D>& scene_entry(std::string_view name);

}  // namespace kerf
