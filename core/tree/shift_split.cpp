#include "core/tree/shift_split.h"

#include "core/tree/criteria.h"
#include "core/tree/split.h"

namespace kerf {

template <int D>
std::optional<ReferencePoint> shifted_partitioner(const Tree<D>& tree, NodeId leaf, const Config& config) {
  const Node<D>& node = tree[leaf];
  if (node.parent.is_none()) return std::nullopt;
  std::vector<Interval> intervals;
  intervals.reserve(node.entries.size());
  for (const Entry& entry : node.entries)
    intervals.push_back(node.unsorted ? tree.project(node.direction, entry.object) : entry.key);
  return best_reference_point(intervals, config_at(tree, leaf, config));
}

template <int D>
std::optional<OperatorActed> shift_split(Tree<D>& tree, NodeId leaf, const Config& config, Refusal& refusal) {
  const std::optional<ReferencePoint> point = shifted_partitioner(tree, leaf, config);
  if (!point) {
    refusal = Refusal::no_partitioner;
    return std::nullopt;
  }
  if (const auto forbidden = forbids_division(tree, leaf, redundancy(point->quality), config)) {
    refusal = *forbidden;
    return std::nullopt;
  }
  const NodeRef ref = tree.ref(leaf);
  const std::uint32_t direction = tree[leaf].direction;
  const float parent_offset = tree[tree[leaf].parent].plane.offset;
  const Quality after = divide(tree, leaf, direction, point->offset);
  return OperatorActed{Operator::shift_split, ref,          {after.population, 0, 0}, after, direction,
                       parent_offset,         point->offset};
}

#define KERF_INSTANTIATE(D)                                                                             \
  template std::optional<ReferencePoint> shifted_partitioner<D>(const Tree<D>&, NodeId, const Config&); \
  template std::optional<OperatorActed> shift_split<D>(Tree<D>&, NodeId, const Config&, Refusal&);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
