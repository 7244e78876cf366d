#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/config.h"
#include "core/trace/event.h"
#include "core/tree/partitioner.h"
#include "core/tree/tree.h"

namespace kerf {

/// What became of a candidate.
enum class Ballot : std::uint8_t {
  chosen,
  beaten,       ///< good, but another has a better score
  unbalanced,   ///< its best point leaves one side with too few objects
  redundant,    ///< its best point cuts too many objects
  undividing,   ///< at every point one child has all objects
  unconfirmed,  ///< good for the sample of objects, but not for all of them
  overruled,    ///< chosen, had a decision not taken another
};
std::string_view to_string(Ballot ballot);

/// A candidate partitioner of a leaf or node, judged as the operator judged it.
struct BallotEntry {
  std::uint32_t direction = 0;
  Scalar offset = 0;
  Quality quality;     ///< over the sample; over all objects where they are few, and of the chosen one
  bool exact = false;  ///< over all objects
  Ballot result = Ballot::beaten;
  bool taken = false;  ///< by a decision; the result is what became of it without one
};
/// "chosen", "taken by a decision; by itself refused: cuts too many".
std::string result_text(const BallotEntry& entry);

/// All candidates that `op` had at a node (paper sections 3.2 and 4): for a split every direction tried, the
/// chosen one first, then the good ones, then the others, each by falling score; for a shift-split and a
/// balance the one direction that they may use. The tree is as it was before the operator. Empty for a merge
/// and a swap, which choose nothing. Recomputed, never stored.
template <int D>
std::vector<BallotEntry> ballot(const Tree<D>& tree, Operator op, NodeId node, const Config& config);

}  // namespace kerf
