#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "core/scene/scene.h"
#include "frames/page/cell.h"

namespace kerf {

/// The recorded motion of a scene: the shapes of its bodies and their poses in each step. All measurements on
/// it see the same motion.
template <int D>
struct Take {
  std::vector<Shape<D>> shapes;
  std::vector<Mobility> mobility;
  std::vector<std::vector<Pose<D>>> poses;  ///< by step, then by body
};

/// The length of a scene's run: objects come during the first `grow` steps; the next `steps` count.
struct SceneLength {
  std::uint32_t objects = 0;
  std::uint32_t grow = 0;
  std::uint32_t steps = 0;
};

/// Runs the scene with the exact broad phase; in heaps, one object falls again in every second step. Throws
/// UsageError for a scene that does not exist in D dimensions or cannot be so large.
template <int D>
Take<D> record(std::string_view scene, const SceneLength& length, const Poll& poll);

/// The scene of that name in D dimensions.
template <int D>
const SceneEntry<D>& scene_entry(std::string_view name);

}  // namespace kerf
