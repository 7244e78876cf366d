#include "core/bsp/ordered_step.h"

#include <vector>

#include "core/base/tuning.h"
#include "core/bsp/ordered_sweep.h"
#include "core/bsp/view_leaf.h"
#include "core/tree/placement.h"
#include "core/tree/subtree.h"

namespace kerf {

/// Placement is never deferred: it is what makes the pairs complete. Objects that left the world are reported
/// before any entry goes.
template <int D>
template <class Trace>
std::uint64_t OrderedStep<D>::place(const StepContext<D>& step, Reporter<Trace>& reporter) {
  Tree<D>& tree = step.tree;
  const ObjectTable<D>& latest = step.requests.latest();
  std::vector<ObjectId> leaving;
  std::vector<ObjectId> entering;
  for (const ObjectId object : step.requests.changed()) {
    const bool was_placed = tree.table.is_placed(object);
    const bool is_placed = latest.is_placed(object);
    if (was_placed && is_placed && try_keep_in_leaves(tree, object, latest.volume(object))) continue;
    if (was_placed) leaving.push_back(object);
    if (is_placed) entering.push_back(object);
  }
  for (const ObjectId object : leaving)
    if (!latest.is_placed(object)) reporter.report([&] { return ObjectPlaced{object, 0}; });
  displace<D>(tree, tree.root(), leaving);
  for (const ObjectId object : step.requests.changed()) tree.table.copy(latest, object);
  for (const ObjectId object : entering) {
    const std::uint32_t leaves = kerf::place(tree, tree.root(), object, 0);
    reporter.report([&] { return ObjectPlaced{object, leaves}; });
  }
  return entering.size();
}

template <int D>
void OrderedStep<D>::sort(Tree<D>& tree) {
  for_each_node(tree, tree.root(), [&tree](NodeId id) {
    if (!tree[id].unsorted) return;
    renew_keys(tree, id);
    sort_entries(tree[id].entries);
    tree[id].unsorted = false;
  });
}

/// The list of a leaf lies along its parent's normal. Where the paper's criteria let a leaf grow without end,
/// that may be an axis on which all boxes coincide (HARD_CASES.md, S6): such a leaf is swept by bytes along
/// the best axis, whatever the policy.
template <int D>
void OrderedStep<D>::find(const Tree<D>& tree, NodeId leaf, LeafScratch<D>& scratch, PairBuffer& pairs) {
  if (tree[leaf].entries.size() <= tuning::kLongList)
    return sweep_leaf(tree.table, tree[leaf], scratch.ordered, pairs);
  const std::size_t begin = pairs.size();
  view_leaf(tree, tree.table, leaf, scratch.view);
  scratch.byte_sweep.find(scratch.view, pairs);
  if (tree.table.kind() != VolumeKind::box) drop_separated(tree.table, begin, pairs);
}

#define KERF_INSTANTIATE(D, TRACE) \
  template std::uint64_t OrderedStep<D>::place(const StepContext<D>&, Reporter<TRACE>&);
KERF_FOR_EACH_TRACE(KERF_INSTANTIATE)
#undef KERF_INSTANTIATE
template class OrderedStep<2>;
template class OrderedStep<3>;

}  // namespace kerf
