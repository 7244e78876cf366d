#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "viz/draw/draw_context.h"

namespace kerf {

/// Those of some pairs whose objects can be drawn and are shown, `most` of them. `shown`: by object; empty:
/// all.
template <int D>
std::vector<Pair> drawable_pairs(std::span<const Pair> pairs, std::span<const Body<D>> bodies,
                                 std::span<const std::uint8_t> shown, std::size_t most);

/// What another engine got wrong in a step.
template <int D>
struct WrongPairLines {
  std::span<const Body<D>> bodies;
  std::span<const Pair> missed;
  std::span<const Pair> extra;
};

/// Lines between their objects that cannot be overlooked: thick, edged in ink, with a diamond.
template <int D>
void draw_wrong_pairs(const DrawContext<D>& frame, const WrongPairLines<D>& wrong, Batch& batch);

}  // namespace kerf
