#pragma once

#include <span>
#include <vector>

#include "core/objects/broad_phase.h"
#include "frames/bench/step_block.h"

namespace kerf {

/// The complete set of pairs of some boxes, of which the first `moving` are not fixed and some may be absent:
/// by brute force for few, by sort-and-sweep for many, by columns for very many.
template <int D>
std::vector<Pair> true_pairs(std::span<const Box<D>> boxes, std::uint32_t moving);

/// The same, found by another algorithm, too: each of them may be measured, and must not judge itself. Takes
/// two to five times as long. Throws as `agreed_pairs` does.
template <int D>
std::vector<Pair> confirmed_pairs(std::span<const Box<D>> boxes, std::uint32_t moving);

/// The pairs that two empty broad phases find of these boxes. Throws std::logic_error if they differ.
template <int D>
std::vector<Pair> agreed_pairs(BroadPhase<D>& oracle, BroadPhase<D>& other, std::span<const Box<D>> boxes,
                               std::uint32_t moving);

/// The difference between `found` and the truth.
struct Difference {
  std::uint64_t missed = 0;
  std::uint64_t extra = 0;  ///< invented, or reported twice
};
Difference compare(std::span<const Pair> found, std::vector<Pair> truth);

}  // namespace kerf
