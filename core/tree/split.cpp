#include "core/tree/split.h"

#include <algorithm>
#include <utility>

#include "core/base/list_room.h"

namespace kerf {
namespace {

/// Counts a leaf's entries on each side of a partitioner; their keys lie along its direction afterwards.
template <int D>
Quality measure_along(Tree<D>& tree, NodeId leaf, std::uint32_t direction, bool project_anew, Scalar offset) {
  Quality quality{tree[leaf].population, 0, 0};
  for (Entry& entry : tree[leaf].entries) {
    if (project_anew) entry.key = tree.project(direction, entry.object);
    count(classify(entry.key, offset), quality);
  }
  return quality;
}

/// The partitioner as a candidate; none if it divides nothing.
template <int D>
std::optional<Candidate> candidate_of(const Tree<D>& tree, NodeId leaf, const ChosenPlane& plane) {
  std::vector<Interval> intervals;
  for (const Entry& entry : tree[leaf].entries)
    intervals.push_back(tree.project(plane.direction, entry.object));
  const Quality quality = measure(intervals, plane.offset);
  if (std::max(quality.left, quality.right) >= quality.population) return std::nullopt;
  return Candidate{plane.direction, plane.offset, quality, true};
}

}  // namespace

template <int D>
std::optional<Refusal> forbids_division(const Tree<D>& tree, NodeId leaf, std::uint32_t straddlers,
                                        const Config& config) {
  if (tree[leaf].depth >= std::min(config.max_height, kMaxHeight)) return Refusal::height;
  const auto entries = static_cast<double>(tree.entries() + straddlers);
  if (entries > static_cast<double>(config.max_entries) * tree.objects()) return Refusal::entries;
  return std::nullopt;
}

template <int D>
Quality divide(Tree<D>& tree, NodeId leaf, std::uint32_t direction, Scalar offset) {
  const bool same_list = tree[leaf].direction == direction;
  const bool sorted = same_list && !tree[leaf].unsorted;
  const Plane<D> plane{tree.directions()[direction], offset};
  const DepthMask bit = depth_bit(tree[leaf].depth);
  const Quality after = measure_along(tree, leaf, direction, !sorted, offset);
  std::vector<Entry> left;
  std::vector<Entry> right;
  make_list_room(left, after.left);
  make_list_room(right, after.right);
  for (Entry entry : tree[leaf].entries) {
    const Sides sides = classify(entry.key, offset);
    if (sides.straddle()) entry.straddle |= bit;
    if (sides.left) left.push_back(entry);
    if (sides.right) right.push_back(entry);
  }
  const NodeId left_id = tree.make_leaf(leaf, false, direction);
  const NodeId right_id = tree.make_leaf(leaf, true, direction);
  const auto fill = [&](NodeId child, std::vector<Entry> entries) {
    tree[child].population = static_cast<std::uint32_t>(entries.size());
    tree[child].unsorted = !sorted;
    tree.set_entries(child, std::move(entries));
  };
  fill(left_id, std::move(left));
  fill(right_id, std::move(right));
  tree.set_entries(leaf, {});  // an inner node keeps no memory for entries
  Node<D>& node = tree[leaf];
  node.plane = plane;
  node.direction = direction;
  node.left = left_id;
  node.right = right_id;
  node.unsorted = false;
  node.refusals = 0;
  node.retry_step = 0;
  return after;
}

template <int D>
std::optional<OperatorActed> split(Tree<D>& tree, NodeId leaf, const Config& config, Refusal& refusal) {
  return split(tree, leaf, config, nullptr, refusal);
}

template <int D>
std::optional<OperatorActed> split(Tree<D>& tree, NodeId leaf, const Config& config, const Decision* decision,
                                   Refusal& refusal) {
  if (decision != nullptr && !decision->plane) {
    refusal = Refusal::decided;
    return std::nullopt;
  }
  if (const auto forbidden = forbids_division(tree, leaf, 0, config)) {
    refusal = *forbidden;
    return std::nullopt;
  }
  const std::optional<Candidate> chosen = decision != nullptr ? candidate_of(tree, leaf, *decision->plane)
                                                              : choose_partitioner(tree, leaf, config);
  if (!chosen) {
    refusal = Refusal::no_partitioner;
    return std::nullopt;
  }
  if (const auto forbidden = forbids_division(tree, leaf, redundancy(chosen->quality), config)) {
    refusal = *forbidden;
    return std::nullopt;
  }
  const NodeRef ref = tree.ref(leaf);
  const Quality after = divide(tree, leaf, chosen->direction, chosen->offset);
  return OperatorActed{Operator::split, ref, {after.population, 0, 0}, after, chosen->direction, 0,
                       chosen->offset};
}

#define KERF_INSTANTIATE(D)                                                                                  \
  template std::optional<Refusal> forbids_division<D>(const Tree<D>&, NodeId, std::uint32_t, const Config&); \
  template Quality divide<D>(Tree<D>&, NodeId, std::uint32_t, Scalar);                                       \
  template std::optional<OperatorActed> split<D>(Tree<D>&, NodeId, const Config&, Refusal&);                 \
  template std::optional<OperatorActed> split<D>(Tree<D>&, NodeId, const Config&, const Decision*, Refusal&);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
