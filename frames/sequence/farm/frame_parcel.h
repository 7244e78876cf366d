#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "viz/draw/frame_planner.h"

namespace kerf {

/// The content of one frame, independent of the simulation.
template <int D>
struct FrameParcel {
  std::vector<Body<D>> bodies;
  std::vector<Pair> pairs;
  std::vector<Pair> contacts;
  std::vector<Pair> missed;
  std::vector<Pair> extra;
  Caption caption;
  FramePlan<D> plan;

  /// The renderer's input beside `plan`.
  [[nodiscard]] FrameInput<D> input() const {
    return {bodies, nullptr, pairs, contacts, {}, caption, kHighlightSteps, missed, extra};
  }
};

/// Serialises it for another process of the same program.
template <int D>
std::vector<std::uint8_t> pack(const FrameInput<D>& input, const FramePlan<D>& plan);
/// Throws std::runtime_error if the bytes end too soon.
template <int D>
FrameParcel<D> unpack(std::span<const std::uint8_t> bytes);

}  // namespace kerf
