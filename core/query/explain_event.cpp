#include "core/query/explain_event.h"

#include <algorithm>

#include "core/base/counted.h"
#include "core/base/float_mode.h"
#include "core/query/criteria_text.h"
#include "core/query/history.h"
#include "core/query/text.h"
#include "core/replay/cursor.h"
#include "core/trace/event_facts.h"
#include "core/tree/criteria.h"

namespace kerf {
namespace {

/// A merge of a node that is not thin was not the scheduler's: too many entries were shed.
template <int D>
std::string reason_of(const BspState<D>& before, const Deed& deed, const GivenNames& names) {
  if (!before.tree.is_alive(deed.node))
    return "its node is dead: it was merged, or replaced by a swap, since it was listed";
  const NodeId id = deed.node.node;
  std::string wish = node_text(id) + " was " + criterion_text(before.tree, id, before.config, names);
  if (deed.op == Operator::merge && !wants_merge(before.tree, id, before.config))
    return wish + "; it was merged because the tree had " +
           counted(before.tree.entries(), "entry", "entries") + " for " +
           counted(before.tree.objects(), "object");
  if (deed.op == Operator::swap)
    return wish + ", and no shift of its partitioner was good, so that it was listed for a swap";
  return wish;
}

/// A listed shift-split that finds no point becomes a split.
bool may_become(Operator listed, Operator acted) {
  return listed == acted || (listed == Operator::shift_split && acted == Operator::split);
}

/// The last time before the event when the operator was put into the event list, if it was (balance never
/// is).
template <int D>
std::optional<Event> scheduling_of(RecordingReader<D>& recording, const Event& event, const Deed& deed) {
  std::optional<Event> found;
  for (const Event& other : node_history(recording, deed.node.node, event.step)) {
    const auto* scheduled = scheduled_of(other);
    if (other.id >= event.id || scheduled == nullptr) continue;
    if (scheduled->node == deed.node && may_become(scheduled->op, deed.op)) found = other;
  }
  return found;
}

template <int D>
std::vector<NodeId> leaves_of(const Tree<D>& tree, ObjectId object) {
  std::vector<NodeId> leaves;
  for_each_node(tree, tree.root(), [&](NodeId id) {
    const auto& entries = tree[id].entries;
    if (std::ranges::find(entries, object, &Entry::object) != entries.end()) leaves.push_back(id);
  });
  return leaves;
}

template <int D>
std::string ballot_text(const EventExplanation<D>& e) {
  std::string text = e.ballot.empty() ? "" : "candidates:\n";
  for (std::size_t k = 0; k < e.ballot.size(); ++k) {
    const BallotEntry& entry = e.ballot[k];
    text += "  candidate " + std::to_string(k) + ": direction " + std::to_string(entry.direction) + ", " +
            plane_text(Plane<D>{e.normals[k], entry.offset}) + ": " + quality_text(entry.quality) +
            (entry.exact ? "" : " of a sample") + ", score " +
            number_text(static_cast<double>(score(entry.quality))) + "; " + result_text(entry) + "\n";
  }
  return text;
}

}  // namespace

template <int D>
EventExplanation<D> explain_event(Replayer<D>& replayer, std::uint64_t id) {
  const DefaultFloats floats;
  EventExplanation<D> result;
  result.event = replayer.recording().event(id);
  if (const auto object = object_of(result.event))
    result.leaves = leaves_of(state_after(replayer, id).tree, *object);
  const auto deed = deed_of(result.event);
  if (!deed) return result;
  const BspState<D> before = state_before(replayer, id);
  result.reason = reason_of(before, *deed, replayer.recording().info().names);
  result.scheduled = scheduling_of(replayer.recording(), result.event, *deed);
  result.ballot = ballot_of(before, result.event);
  for (const BallotEntry& entry : result.ballot)
    result.normals.push_back(before.tree.directions()[entry.direction]);
  return result;
}

template <int D>
std::string to_text(const EventExplanation<D>& e, const GivenNames& names) {
  const DefaultFloats floats;
  std::string text = describe(e.event, names) + "\n";
  if (!e.reason.empty()) text += e.reason + "\n";
  if (e.scheduled) text += "listed by " + describe(*e.scheduled, names) + "\n";
  for (const NodeId leaf : e.leaves) text += "  in leaf " + node_text(leaf) + "\n";
  return text + ballot_text(e);
}

#define KERF_INSTANTIATE(D)                                                   \
  template EventExplanation<D> explain_event<D>(Replayer<D>&, std::uint64_t); \
  template std::string to_text<D>(const EventExplanation<D>&, const GivenNames&);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
