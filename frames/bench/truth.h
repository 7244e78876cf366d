#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/broad_phase/broad_phase.h"
#include "frames/bench/step_block.h"

namespace kerf {

/// The complete set of pairs of some boxes, of which the first `moving` are not fixed.
template <int D>
std::vector<Pair> true_pairs(std::span<const Box<D>> boxes, std::uint32_t moving);

/// How `found` differs from the truth.
struct Difference {
  std::uint64_t missed = 0;
  std::uint64_t extra = 0;  ///< invented, or told twice
};
Difference compare(std::span<const Pair> found, std::vector<Pair> truth);

}  // namespace kerf
