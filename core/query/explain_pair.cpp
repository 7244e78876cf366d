#include "core/query/explain_pair.h"

#include <algorithm>
#include <cmath>

#include "core/base/counted.h"
#include "core/base/float_mode.h"
#include "core/base/overloaded.h"
#include "core/query/text.h"
#include "core/replay/cursor.h"

namespace kerf {
namespace {

template <int D>
bool has_entry(const Tree<D>& tree, NodeId leaf, ObjectId object) {
  return std::ranges::any_of(tree[leaf].entries, [&](const Entry& entry) { return entry.object == object; });
}

template <int D>
bool share(const Tree<D>& tree, NodeRef leaf, const Pair& pair) {
  return tree.is_alive(leaf) && tree[leaf.node].is_leaf() && has_entry(tree, leaf.node, pair.a) &&
         has_entry(tree, leaf.node, pair.b);
}

/// Down from the root, left where both are left: to the leaf where the two are compared, or to the node that
/// separates them.
template <int D>
void walk(const Tree<D>& tree, PairExplanation<D>& result) {
  NodeId id = tree.root();
  while (!tree[id].is_leaf()) {
    const Node<D>& node = tree[id];
    HalfSpaceTest<D> test{id,
                          node.depth,
                          node.plane,
                          tree.project(node.direction, result.pair.a),
                          tree.project(node.direction, result.pair.b),
                          {},
                          {}};
    test.a_sides = classify(test.a, node.plane.offset);
    test.b_sides = classify(test.b, node.plane.offset);
    result.tests.push_back(test);
    const bool both_left = test.a_sides.left && test.b_sides.left;
    if (!both_left && !(test.a_sides.right && test.b_sides.right)) return;
    id = both_left ? node.left : node.right;
  }
  result.shared_leaf = id;
}

/// Whether an event can put two objects into one leaf.
bool may_join(const Event& event, const Pair& pair) {
  return std::visit(Overloaded{
                        [&](const ObjectPlaced& e) { return e.object == pair.a || e.object == pair.b; },
                        [](const OperatorActed&) { return true; },
                        [](const AllPlaced&) { return true; },
                        NothingFor<bool, PhaseBegan, OperatorScheduled, OperatorRefused, EventsDeferred>(),
                    },
                    event.body);
}

/// The last event before which the two did not share the leaf.
template <int D>
std::optional<Event> joined_by(Replayer<D>& replayer, std::uint32_t step, NodeRef leaf, const Pair& pair) {
  for (; step > 0; --step) {
    const std::vector<Event> events = replayer.recording().step(step).events;
    replayer.seek(step - 1);
    if (share(replayer.tree().tree(), leaf, pair)) continue;
    for (auto event = events.rbegin(); event != events.rend(); ++event)
      if (may_join(*event, pair) && !share(state_before(replayer, event->id).tree, leaf, pair)) return *event;
    return std::nullopt;
  }
  return std::nullopt;
}

template <int D>
void compare_boxes(PairExplanation<D>& result) {
  result.boxes_overlap = overlaps(result.a_box, result.b_box);
  for (std::size_t axis = 0; axis < D; ++axis) {
    const double gap = std::max(result.a_box.min[axis] - result.b_box.max[axis],
                                result.b_box.min[axis] - result.a_box.max[axis]);
    if (axis > 0 && gap <= result.margin) continue;
    result.axis = static_cast<int>(axis);
    result.margin = gap;
  }
}

/// The box that an object was last asked to have; a table does not keep one that cannot be placed.
template <int D>
Box<D> last_box(RecordingReader<D>& recording, ObjectId object, std::uint32_t step) {
  for (; step > 0; --step) {
    const StepRequests<D>& requests = recording.step(step).requests;
    const auto last = std::find(requests.objects.rbegin(), requests.objects.rend(), object);
    if (last != requests.objects.rend())
      return requests.boxes[static_cast<std::size_t>(requests.objects.rend() - last) - 1];
  }
  return Box<D>::empty();
}

template <int D>
GivenBox<D> box_as_given(Replayer<D>& replayer, ObjectId object, ObjectState state, std::uint32_t step) {
  if (state == ObjectState::absent) return {};
  if (replayer.recording().info().imported)
    if (const auto given = replayer.recording().given_box(object, step)) return *given;
  return to_given(state == ObjectState::placed ? replayer.tree().objects().box(object)
                                               : last_box(replayer.recording(), object, step));
}

template <int D>
void ask_theirs(const RecordingReader<D>& recording, PairExplanation<D>& result) {
  if (!recording.info().imported || result.step == 0) return;
  result.a_filter = recording.filter(result.pair.a, result.step);
  result.b_filter = recording.filter(result.pair.b, result.step);
  result.margin_declared = recording.info().design.margin;
  result.rounding = recording.info().design.rounding;
  result.lacks_theirs = recording.lacks_their_pairs(result.step);
  if (!recording.their_step(result.step)) return;
  const std::vector<Pair> theirs = recording.their_pairs(result.step);
  result.their_times = static_cast<std::size_t>(std::ranges::count(theirs, result.pair));
  for (const auto& [pair, verdict] : recording.judged_pairs(result.step))
    if (pair == result.pair && verdict != PairVerdict::twice) result.their_verdict = verdict;
}

template <int D>
std::string presence(const std::string& name, ObjectState state, const GivenBox<D>& box) {
  if (state == ObjectState::absent) return "object " + name + " is not there";
  return "object " + name + " is in quarantine: its box, " + box_text(box, box) +
         ", is not a number or inverted, and it takes part in no pair";
}

template <int D>
std::string reason_text(const PairExplanation<D>& e) {
  const std::string axis(1, "xyz"[e.axis]);
  if (e.both_fixed) return "both are fixed, and fixed objects are never a pair";
  if (e.undecided_axis)
    return "in the " + to_text(e.rounding) + " that were written they touch along " +
           "xyz"[*e.undecided_axis] + "; what was rounded away decides";
  if (e.is_given_pair)
    return "their boxes overlap on every axis, least along " + axis + ": by " +
           number_text(std::abs(e.margin));
  if (e.boxes_overlap) return "their boxes overlap, but their volumes do not";
  return "axis " + axis + " separates them by " + number_text(e.margin);
}

/// `rounding`: what must round for the boxes with their margin to overlap; empty: nothing.
std::string verdict_text(PairVerdict verdict, const Margin& margin, const std::string& rounding) {
  switch (verdict) {
    case PairVerdict::missed:
      return "the other engine missed it\n";
    case PairVerdict::extra:
      return "the other engine reported it, though it is none\n";
    case PairVerdict::twice:
      return "";
    case PairVerdict::filtered:
      return "it is ignored: the other engine's masks leave it out\n";
    case PairVerdict::listed:
      return "it is ignored: it is one of the pairs that the other engine leaves out by design\n";
    case PairVerdict::undecided:
      return "it is not judged, whether the other engine reported it or not\n";
    case PairVerdict::margin:
      break;
  }
  const bool is_share = margin.share > 0;
  return "the other engine reported it: with its margin of " +
         number_text(is_share ? 100 * margin.share : margin.absolute) + (is_share ? "%" : "") +
         " on each side the boxes overlap" + rounding + "\n";
}

/// Nothing if the other engine is right, or unknown in all steps.
template <int D>
std::string their_text(const PairExplanation<D>& e, const GivenNames& names) {
  if (e.lacks_theirs)
    return "the other engine's pairs of step " + names.step(e.step) + " are not in the recording\n";
  if (!e.their_times) return "";
  const bool rounded = !overlaps(grow(e.a_box, e.margin_declared), grow(e.b_box, e.margin_declared));
  const std::string how = e.rounding == BoundRounding{} ? "floats round it" : "its text may be rounded";
  const std::string rounding = rounded ? ", as " + how : "";
  std::string text = e.their_verdict ? verdict_text(*e.their_verdict, e.margin_declared, rounding) : "";
  if (e.their_verdict == PairVerdict::missed && e.margin == 0)
    text += "they only touch: if what touches was rounded as it was written, they may have been apart\n";
  if (*e.their_times > 1) text += "the other engine reported it " + counted(*e.their_times, "time") + "\n";
  return text;
}

std::string filter_text(const std::optional<GivenFilter>& filter) {
  if (!filter) return "";
  return "  category " + std::to_string(filter->category) + ", mask " + std::to_string(filter->mask);
}

template <int D>
std::string test_text(const PairExplanation<D>& e, const HalfSpaceTest<D>& test, const GivenNames& names) {
  const int digits = digits_apart({double{test.a.lo}, double{test.a.hi}, double{test.b.lo}, double{test.b.hi},
                                   double{test.plane.offset}});
  return "  " + node_text(test.node) + " at depth " + std::to_string(test.depth) + ", " +
         plane_text(test.plane, digits) + ": " + names.object(e.pair.a) + " is " + sides_text(test.a_sides) +
         " " + interval_text(test.a, digits) + ", " + names.object(e.pair.b) + " is " +
         sides_text(test.b_sides) + " " + interval_text(test.b, digits) + "\n";
}

template <int D>
std::string place_text(const PairExplanation<D>& e, const GivenNames& names) {
  if (e.shared_leaf) {
    const std::string since =
        e.shared_since ? "; together there since " + describe(*e.shared_since, names) : "";
    return "both are in leaf " + node_text(*e.shared_leaf) + ", where they are compared" + since + "\n";
  }
  if (e.tests.empty()) return "";
  const HalfSpaceTest<D>& last = e.tests.back();
  const auto margin = std::max(static_cast<double>(last.a.lo) - static_cast<double>(last.b.hi),
                               static_cast<double>(last.b.lo) - static_cast<double>(last.a.hi));
  return "partitioner " + node_text(last.node) + " separates them: along its normal they are " +
         number_text(margin) + " apart, and they are never compared\n";
}

}  // namespace

template <int D>
PairExplanation<D> explain_pair(Replayer<D>& replayer, std::uint32_t step, const Pair& pair) {
  const DefaultFloats floats;
  PairExplanation<D> result;
  result.step = step;
  result.pair = pair;
  replayer.seek(step);
  result.history = pair_history(replayer.recording(), pair, step);
  const ObjectTable<D>& objects = replayer.tree().objects();
  result.a_state = objects.state(pair.a);
  result.b_state = objects.state(pair.b);
  result.a_box = box_as_given(replayer, pair.a, result.a_state, step);
  result.b_box = box_as_given(replayer, pair.b, result.b_state, step);
  ask_theirs(replayer.recording(), result);
  if (result.a_state != ObjectState::placed || result.b_state != ObjectState::placed) return result;
  result.both_fixed = objects.is_fixed(pair.a) && objects.is_fixed(pair.b);
  result.is_pair = objects.is_pair(pair.a, pair.b);
  result.reported = std::ranges::any_of(replayer.tree().pairs(), [&](const Pair& reported) {
    return make_pair(reported.a, reported.b) == pair;
  });
  compare_boxes(result);
  result.is_given_pair = result.is_pair && result.boxes_overlap;
  if (result.is_given_pair)
    result.undecided_axis = undecided_axis(result.rounding, result.a_box, result.b_box);
  walk(replayer.tree().tree(), result);
  if (result.shared_leaf) {
    const NodeRef leaf = replayer.tree().tree().ref(*result.shared_leaf);
    result.shared_since = joined_by(replayer, step, leaf, pair);
  }
  return result;
}

namespace {

std::string title(const RecordingInfo& info, ObjectId object) {
  return info.marks.title(object, info.names.object(object));
}

/// What keeps the two from being compared at all; empty: both are placed.
template <int D>
std::string absence_text(const PairExplanation<D>& e, const GivenNames& names) {
  std::string text;
  if (e.a_state != ObjectState::placed) text = presence(names.object(e.pair.a), e.a_state, e.a_box);
  if (e.b_state == ObjectState::placed) return text;
  return text + (text.empty() ? "" : "; ") + presence(names.object(e.pair.b), e.b_state, e.b_box);
}

template <int D>
std::string comparison_text(const PairExplanation<D>& e, const RecordingInfo& info) {
  const GivenNames& names = info.names;
  std::string text = reason_text(e) + "\n" + their_text(e, names);
  if (e.reported != e.is_pair)
    text += "this is a fault of the tree: by the definition it is the other way round\n";
  if (e.is_pair && !e.is_given_pair)
    text +=
        "rounded outward to floats, with which the tree works, their boxes overlap, so the tree reports "
        "them\n";
  text += "  " + title(info, e.pair.a) + ": " + box_text(e.a_box, e.b_box) + filter_text(e.a_filter) + "\n";
  text += "  " + title(info, e.pair.b) + ": " + box_text(e.b_box, e.a_box) + filter_text(e.b_filter) + "\n";
  if (!e.tests.empty()) text += "from the root:\n";
  for (const HalfSpaceTest<D>& test : e.tests) text += test_text(e, test, names);
  return text + place_text(e, names);
}

}  // namespace

template <int D>
std::string to_text(const PairExplanation<D>& e, const RecordingInfo& info) {
  const DefaultFloats floats;
  const GivenNames& names = info.names;
  const bool is_pair = e.reported && (e.is_given_pair || !e.is_pair);
  const std::string verdict = e.undecided_axis ? " may be a pair" : is_pair ? " are a pair" : " are no pair";
  std::string text = "after step " + names.step(e.step) + ", " + title(info, e.pair.a) + " and " +
                     title(info, e.pair.b) + verdict + ": ";
  const std::string absence = absence_text(e, names);
  text += absence.empty() ? comparison_text(e, info) : absence + "\n" + their_text(e, names);
  for (const PairChange& change : e.history)
    text += std::string(change.is_pair ? "became a pair" : "ceased to be one") + " in step " +
            names.step(change.step) + "\n";
  return text;
}

#define KERF_INSTANTIATE(D)                                                              \
  template PairExplanation<D> explain_pair<D>(Replayer<D>&, std::uint32_t, const Pair&); \
  template std::string to_text<D>(const PairExplanation<D>&, const RecordingInfo&);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
