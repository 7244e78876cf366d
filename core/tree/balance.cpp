#include "core/tree/balance.h"

#include <algorithm>
#include <vector>

#include "core/base/tuning.h"
#include "core/kernels/prefetch.h"
#include "core/tree/criteria.h"
#include "core/tree/placement.h"

namespace kerf {
namespace {

template <int D>
std::vector<Interval> project_all(const Tree<D>& tree, std::uint32_t direction,
                                  const std::vector<Stored>& stored) {
  std::vector<Interval> intervals;
  intervals.reserve(stored.size());
  for (std::size_t k = 0; k < stored.size(); ++k) {
    prefetch(&tree.table.packed(stored[std::min(k + tuning::kPrefetchAhead, stored.size() - 1)].object));
    intervals.push_back(tree.project(direction, stored[k].object));
  }
  return intervals;
}

/// The objects that the two offsets classify differently: lo or hi lies in (d_old, d_new].
std::vector<Stored> affected(const std::vector<Stored>& stored, const std::vector<Interval>& intervals,
                             Scalar old_offset, Scalar new_offset) {
  std::vector<Stored> result;
  for (std::size_t i = 0; i < stored.size(); ++i)
    if (classify(intervals[i], old_offset) != classify(intervals[i], new_offset)) result.push_back(stored[i]);
  return result;
}

template <int D>
void shift(Tree<D>& tree, NodeId inner, const std::vector<Stored>& moving, Scalar new_offset) {
  std::vector<ObjectId> leaving;
  leaving.reserve(moving.size());
  for (const Stored& item : moving) leaving.push_back(item.object);
  displace(tree, inner, leaving);
  tree[inner].plane.offset = new_offset;
  for (const Stored& item : moving) place(tree, inner, item.object, item.above);
}

}  // namespace

template <int D>
std::optional<OperatorActed> balance(Tree<D>& tree, NodeId inner, const Config& config, Refusal& refusal) {
  const Quality before = quality(tree, inner);
  const Scalar old_offset = tree[inner].plane.offset;
  const std::vector<Stored> stored = collect(tree, inner);
  const std::vector<Interval> intervals = project_all(tree, tree[inner].direction, stored);
  const std::optional<ReferencePoint> point = good_reference_point(intervals, config_at(tree, inner, config));
  if (!point) {
    refusal = Refusal::no_partitioner;
    return std::nullopt;
  }
  shift(tree, inner, affected(stored, intervals, old_offset, point->offset), point->offset);
  return OperatorActed{Operator::balance,     tree.ref(inner), before,       quality(tree, inner),
                       tree[inner].direction, old_offset,      point->offset};
}

template std::optional<OperatorActed> balance<2>(Tree<2>&, NodeId, const Config&, Refusal&);
template std::optional<OperatorActed> balance<3>(Tree<3>&, NodeId, const Config&, Refusal&);

}  // namespace kerf
