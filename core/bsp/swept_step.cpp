#include "core/bsp/swept_step.h"

#include <utility>

#include "core/base/tuning.h"
#include "core/bsp/ordered_sweep.h"
#include "core/bsp/place_boxes.h"
#include "core/bsp/view_leaf.h"
#include "core/kernels/prefetch.h"

namespace kerf {

namespace {

/// Brings the tree's table up to date. Where leaves were swept before it differs in the changed objects only,
/// and where these only moved, in boxes only.
template <int D>
void take_latest(const StepContext<D>& step, Mode before) {
  ObjectTable<D>& table = step.tree.table;
  const Requests<D>& requests = step.requests;
  const ObjectTable<D>& latest = requests.latest();
  const std::size_t most = latest.bound() / tuning::kIdsPerCopy;
  if (before == Mode::swept && latest.size() < most && requests.changed().size() < most) {
    for (const ObjectId object : requests.changed()) table.copy(latest, object);
  } else if (before == Mode::swept && requests.are_moves()) {
    table.copy_boxes(latest, step.pool());
  } else {
    table.copy_all(latest, step.pool());
  }
}

}  // namespace

template <int D>
void SweptStep<D>::begin_step(const Tree<D>& tree, std::span<const ObjectId> changed, bool rows) {
  leaf_boxes_.begin(tree, false);
  wants_rows_ = rows;
  rows ? rows_.expect_changes(changed) : rows_.forget();
}

template <int D>
void SweptStep<D>::end_step(const ObjectTable<D>& table, std::span<const Pair> pairs) {
  wants_rows_ ? rows_.take(table, pairs) : rows_.forget();
}

/// Those that still lie in their leaf's cell are looked for first, unless most jump or many come or go.
template <int D>
template <class Trace>
std::uint64_t SweptStep<D>::place_all(const StepContext<D>& step, Mode before, Mode mode,
                                      Reporter<Trace>& reporter) {
  Tree<D>& tree = step.tree;
  const bool many_stay = may_stay(step);
  take_latest(step, before);
  const bool are_far = exceeds(std::as_const(tree.table).packed(), tuning::kOwnPages);
  leaf_boxes_.begin(tree, mode == Mode::swept && are_far && step.config.leaf_boxes);
  place_boxes(step, many_stay, leaf_boxes_);
  reporter.report([&] { return AllPlaced{tree.objects()}; });
  return step.requests.changed().size();
}

template <int D>
void SweptStep<D>::move_in_root(const StepContext<D>& step) {
  Tree<D>& tree = step.tree;
  for (const ObjectId object : step.requests.changed()) {
    tree.table.packed()[object.index()] = step.requests.latest().packed(object);
    tree[tree.root()].unsorted = true;
  }
}

template <int D>
void SweptStep<D>::find(const Tree<D>& tree, NodeId leaf, LeafScratch<D>& scratch, PairBuffer& pairs) {
  const std::size_t begin = pairs.size();
  if (leaf_boxes_.has(tree, leaf)) {
    view_all_but_boxes(tree, tree.table, leaf, scratch.view);
    leaf_boxes_.swap(leaf, scratch.view.boxes);
    scratch.byte_sweep.find(scratch.view, pairs);
    leaf_boxes_.swap(leaf, scratch.view.boxes);
  } else {
    view_leaf(tree, tree.table, leaf, scratch.view);
    scratch.byte_sweep.find(scratch.view, pairs);
  }
  if (tree.table.kind() != VolumeKind::box) drop_separated(tree.table, begin, pairs);
}

#define KERF_INSTANTIATE(D, TRACE) \
  template std::uint64_t SweptStep<D>::place_all(const StepContext<D>&, Mode, Mode, Reporter<TRACE>&);
KERF_FOR_EACH_TRACE(KERF_INSTANTIATE)
#undef KERF_INSTANTIATE
template class SweptStep<2>;
template class SweptStep<3>;

}  // namespace kerf
