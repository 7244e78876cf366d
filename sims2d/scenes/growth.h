#pragma once

#include <cstdint>
#include <memory>

#include "core/scene/scene.h"

namespace kerf::inline sims2d {

/// How the number of moving objects of a scene grows: evenly, from the first step to step `steps`.
struct Growth {
  std::uint32_t objects = 0;
  std::uint32_t steps = 1;
  std::uint32_t recycle = 0;  ///< steps between two objects that fall anew after the growth; 0: none does
  std::uint32_t nudge = 0;    ///< ulps by which the first object is moved aside

  /// Objects that are there after `step` steps.
  [[nodiscard]] std::uint32_t due(std::uint32_t step) const;
};

inline constexpr std::uint32_t kMaxObjects2d = 100'000;

/// The growth that `options` describe, with the scene's defaults for zeros: `default_objects`, and a time
/// over which the objects fall as densely in a large scene as in a small one. Throws std::invalid_argument
/// for more than `kMaxObjects2d`.
Growth growth_of(const SceneOptions& options, std::uint32_t default_objects);

/// Makes a scene whose objects are all there from the first step on.
template <class S, std::uint32_t DefaultObjects>
std::unique_ptr<Scene<2>> make_at_once(BroadPhase<2>& broad_phase, const SceneOptions& options) {
  const std::uint32_t objects = growth_of(options, DefaultObjects).objects;
  return std::make_unique<S>(broad_phase, objects, options.seed);
}

}  // namespace kerf::inline sims2d
