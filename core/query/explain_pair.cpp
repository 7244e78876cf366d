#include "core/query/explain_pair.h"

#include <algorithm>

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
/// parts them.
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

/// What can put two objects into one leaf.
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
  for (int axis = 0; axis < D; ++axis) {
    const double gap =
        std::max(static_cast<double>(result.a_box.min[axis]) - static_cast<double>(result.b_box.max[axis]),
                 static_cast<double>(result.b_box.min[axis]) - static_cast<double>(result.a_box.max[axis]));
    if (axis > 0 && gap <= result.margin) continue;
    result.axis = axis;
    result.margin = gap;
  }
}

std::string presence(ObjectId object, ObjectState state) {
  const std::string name = "object " + std::to_string(object.value);
  if (state == ObjectState::absent) return name + " is not there";
  return name + " is in quarantine: its box is NaN or inverted, and it takes part in no pair";
}

template <int D>
std::string reason_text(const PairExplanation<D>& e) {
  const std::string axis(1, "xyz"[e.axis]);
  if (e.both_fixed) return "both are fixed, and fixed objects are never a pair";
  if (e.is_pair)
    return "their boxes overlap on every axis, least along " + axis + ": by " + number_text(-e.margin);
  if (e.boxes_overlap) return "their boxes overlap, but their volumes do not";
  return "axis " + axis + " separates them by " + number_text(e.margin);
}

/// Nothing if the other engine is right, or unknown.
template <int D>
std::string their_text(const PairExplanation<D>& e) {
  if (!e.their_times) return "";
  if (*e.their_times == 0 && e.is_pair) return "the other engine missed it\n";
  if (*e.their_times > 0 && !e.is_pair) return "the other engine reported it, though it is none\n";
  if (*e.their_times > 1)
    return "the other engine reported it " + std::to_string(*e.their_times) + " times\n";
  return "";
}

template <int D>
std::string test_text(const PairExplanation<D>& e, const HalfSpaceTest<D>& test) {
  return "  " + node_text(test.node) + " at depth " + std::to_string(test.depth) + ", " +
         plane_text(test.plane) + ": " + std::to_string(e.pair.a.value) + " is " + sides_text(test.a_sides) +
         " " + interval_text(test.a) + ", " + std::to_string(e.pair.b.value) + " is " +
         sides_text(test.b_sides) + " " + interval_text(test.b) + "\n";
}

template <int D>
std::string place_text(const PairExplanation<D>& e) {
  if (e.shared_leaf) {
    const std::string since = e.shared_since ? "; together there since " + describe(*e.shared_since) : "";
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
  PairExplanation<D> result;
  result.step = step;
  result.pair = pair;
  replayer.seek(step);
  result.history = pair_history(replayer.recording(), pair, step);
  const ObjectTable<D>& objects = replayer.tree().objects();
  result.a_state = objects.state(pair.a);
  result.b_state = objects.state(pair.b);
  if (result.a_state != ObjectState::placed || result.b_state != ObjectState::placed) return result;
  result.a_box = objects.box(pair.a);
  result.b_box = objects.box(pair.b);
  result.both_fixed = objects.is_fixed(pair.a) && objects.is_fixed(pair.b);
  result.is_pair = objects.is_pair(pair.a, pair.b);
  result.told = std::ranges::any_of(replayer.tree().pairs(),
                                    [&](const Pair& told) { return make_pair(told.a, told.b) == pair; });
  if (replayer.recording().their_step(step)) {
    const std::vector<Pair> theirs = replayer.recording().their_pairs(step);
    result.their_times = static_cast<std::size_t>(std::ranges::count(theirs, pair));
  }
  compare_boxes(result);
  walk(replayer.tree().tree(), result);
  if (result.shared_leaf) {
    const NodeRef leaf = replayer.tree().tree().ref(*result.shared_leaf);
    result.shared_since = joined_by(replayer, step, leaf, pair);
  }
  return result;
}

template <int D>
std::string to_text(const PairExplanation<D>& e) {
  const std::string names = std::to_string(e.pair.a.value) + " and " + std::to_string(e.pair.b.value);
  std::string text = "after step " + std::to_string(e.step) + ", " + names +
                     (e.told ? " are a pair" : " are no pair") + ": ";
  if (e.a_state != ObjectState::placed) return text + presence(e.pair.a, e.a_state) + "\n";
  if (e.b_state != ObjectState::placed) return text + presence(e.pair.b, e.b_state) + "\n";
  text += reason_text(e) + "\n";
  text += their_text(e);
  if (e.told != e.is_pair)
    text += "this is a fault of the tree: by the definition it is the other way round\n";
  text += "  " + std::to_string(e.pair.a.value) + ": " + box_text(e.a_box) + "\n";
  text += "  " + std::to_string(e.pair.b.value) + ": " + box_text(e.b_box) + "\n";
  if (!e.tests.empty()) text += "from the root:\n";
  for (const HalfSpaceTest<D>& test : e.tests) text += test_text(e, test);
  text += place_text(e);
  for (const PairChange& change : e.history)
    text += std::string(change.is_pair ? "became a pair" : "ceased to be one") + " in step " +
            std::to_string(change.step) + "\n";
  return text;
}

#define KERF_INSTANTIATE(D)                                                              \
  template PairExplanation<D> explain_pair<D>(Replayer<D>&, std::uint32_t, const Pair&); \
  template std::string to_text<D>(const PairExplanation<D>&);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
