#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/query/history.h"
#include "core/recording/recording_info.h"
#include "core/replay/replayer.h"

namespace kerf {

/// Two objects beside the partitioner of one node.
template <int D>
struct HalfSpaceTest {
  NodeId node;
  std::uint32_t depth = 0;
  Plane<D> plane;
  Interval a;  ///< the objects' projections on its normal
  Interval b;
  Sides a_sides;
  Sides b_sides;
};

/// Why two objects are a pair at the end of a step, or why not. It has many fields, since it is a record of
/// all that the explanation says.
template <int D>
struct PairExplanation {
  std::uint32_t step = 0;
  Pair pair;
  ObjectState a_state = ObjectState::absent;
  ObjectState b_state = ObjectState::absent;
  GivenBox<D> a_box;  ///< as it was given; of an object in quarantine, too
  GivenBox<D> b_box;
  bool both_fixed = false;
  bool reported = false;  ///< the tree reported the pair
  bool is_pair =
      false;  ///< by the definition, in the tree's floats; anything else than `reported` is a fault
  bool is_given_pair = false;              ///< by the definition, in the precision given
  std::optional<std::size_t> their_times;  ///< how often the other engine reported it, if its pairs are known
  std::optional<PairVerdict> their_verdict;  ///< none: it is right
  bool lacks_theirs = false;                 ///< its pairs are known of other steps, but not of this one
  std::optional<GivenFilter> a_filter;       ///< of the other engine, if it is known
  std::optional<GivenFilter> b_filter;
  Margin margin_declared;
  BoundRounding rounding;             ///< of what was written of the boxes
  std::optional<int> undecided_axis;  ///< what was rounded away there decides whether the two are a pair
  bool boxes_overlap = false;
  int axis = 0;                         ///< on which the boxes are furthest apart, or overlap least
  double margin = 0;                    ///< the distance; negative: the overlap
  std::vector<HalfSpaceTest<D>> tests;  ///< from the root down, as long as they share a side
  std::optional<NodeId> shared_leaf;    ///< the canonical one, where they are compared
  std::optional<Event> shared_since;    ///< after this event they shared it
  std::vector<PairChange> history;      ///< up to this step
};

/// Throws std::runtime_error for a step that the recording does not have.
template <int D>
PairExplanation<D> explain_pair(Replayer<D>& replayer, std::uint32_t step, const Pair& pair);

/// The explanation in sentences, a line each, with the labels of the two.
template <int D>
std::string to_text(const PairExplanation<D>& explanation, const RecordingInfo& info);

}  // namespace kerf
