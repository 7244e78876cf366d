#include "tests/support/planted_tree.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/bsp/ordered_sweep.h"
#include "core/tree/placement.h"
#include "core/tree/split.h"
#include "core/tree/subtree.h"
#include "tests/support/boxes.h"

namespace kerf::test {

template <int D>
std::shared_ptr<const Projector<D>> few_directions() {
  static const auto kProjector =
      std::make_shared<const Projector<D>>(DirectionSet<D>(24, 1), VolumeKind::box);
  return kProjector;
}

template <int D>
kerf::Tree<D> tree_of(std::span<const Box<D>> boxes) {
  kerf::Tree<D> tree(few_directions<D>());
  for (std::uint32_t k = 0; k < boxes.size(); ++k) {
    EXPECT_EQ(tree.table.insert({k}, boxes[k], Mobility::moving), Status::ok);
    EXPECT_EQ(place(tree, tree.root(), {k}, 0), 1U);
  }
  sort_phase(tree);
  return tree;
}

template <int D>
void sort_phase(kerf::Tree<D>& tree) {
  for_each_node(tree, tree.root(), [&tree](NodeId id) {
    if (!tree[id].unsorted) return;
    renew_keys(tree, id);
    sort_entries(tree[id].entries);
    tree[id].unsorted = false;
  });
}

template <int D>
void plant(kerf::Tree<D>& tree, NodeId leaf, std::uint32_t direction, Scalar offset) {
  divide(tree, leaf, direction, offset);
  sort_phase(tree);
}

template <int D>
void plant_at_random(kerf::Tree<D>& tree, std::uint32_t planes, std::uint32_t max_depth, Random& random) {
  for (std::uint32_t i = 0; i < planes; ++i) {
    NodeId leaf = tree.root();
    while (!tree[leaf].is_leaf()) leaf = random.below(2) == 0 ? tree[leaf].left : tree[leaf].right;
    const std::vector<Entry>& entries = tree[leaf].entries;
    if (entries.empty() || tree[leaf].depth >= max_depth) continue;
    const std::uint32_t direction = random.below(tree.directions().size());
    const ObjectId object = entries[random.below(static_cast<std::uint32_t>(entries.size()))].object;
    const Interval end = tree.project(direction, object);
    plant(tree, leaf, direction, random.below(2) == 0 ? end.lo : end.hi);
  }
}

template <int D>
kerf::Tree<D> random_tree(Random& random, int objects, double half, std::uint32_t planes,
                          std::uint32_t max_depth) {
  std::vector<Box<D>> boxes;
  for (int k = 0; k < objects; ++k) boxes.push_back(random_box<D>(random, 20, half));
  auto tree = tree_of<D>(boxes);
  plant_at_random(tree, planes, max_depth, random);
  return tree;
}

template <int D>
std::vector<Interval> shadows(const kerf::Tree<D>& tree, std::uint32_t direction) {
  std::vector<Interval> intervals;
  for_each_placed(tree.table, [&](ObjectId object) { intervals.push_back(tree.project(direction, object)); });
  return intervals;
}

template <int D>
std::vector<NodeId> inner_nodes(const kerf::Tree<D>& tree) {
  std::vector<NodeId> nodes;
  for_each_node(tree, tree.root(), [&](NodeId id) {
    if (!tree[id].is_leaf()) nodes.push_back(id);
  });
  return nodes;
}

template <int D>
std::vector<ObjectId> objects_below(const kerf::Tree<D>& tree, NodeId from) {
  std::vector<ObjectId> objects;
  for_each_node(tree, from, [&](NodeId id) {
    for (const Entry& entry : tree[id].entries) objects.push_back(entry.object);
  });
  std::sort(objects.begin(), objects.end());
  objects.erase(std::unique(objects.begin(), objects.end()), objects.end());
  return objects;
}

template <int D>
std::vector<Pair> swept(kerf::Tree<D>& tree) {
  sort_phase(tree);
  SweepBuffer<D> buffer;
  PairBuffer pairs;
  for_each_node(tree, tree.root(), [&](NodeId id) {
    if (tree[id].is_leaf()) sweep_leaf(tree.table, tree[id], buffer, pairs);
  });
  return {pairs.all().begin(), pairs.all().end()};
}

template <int D>
std::vector<Pair> overlapping(const kerf::Tree<D>& tree) {
  std::vector<Pair> pairs;
  for (std::uint32_t a = 0; a < tree.table.bound(); ++a) {
    for (std::uint32_t b = a + 1; b < tree.table.bound(); ++b) {
      const bool both = tree.table.is_placed({a}) && tree.table.is_placed({b});
      if (both && overlaps(tree.table.box({a}), tree.table.box({b}))) pairs.push_back({{a}, {b}});
    }
  }
  return pairs;
}

#define KERF_INSTANTIATE(D)                                                                  \
  template std::shared_ptr<const Projector<D>> few_directions<D>();                          \
  template kerf::Tree<D> tree_of<D>(std::span<const Box<D>>);                                \
  template void sort_phase<D>(kerf::Tree<D>&);                                               \
  template void plant<D>(kerf::Tree<D>&, NodeId, std::uint32_t, Scalar);                     \
  template void plant_at_random<D>(kerf::Tree<D>&, std::uint32_t, std::uint32_t, Random&);   \
  template kerf::Tree<D> random_tree<D>(Random&, int, double, std::uint32_t, std::uint32_t); \
  template std::vector<Interval> shadows<D>(const kerf::Tree<D>&, std::uint32_t);            \
  template std::vector<NodeId> inner_nodes<D>(const kerf::Tree<D>&);                         \
  template std::vector<ObjectId> objects_below<D>(const kerf::Tree<D>&, NodeId);             \
  template std::vector<Pair> swept<D>(kerf::Tree<D>&);                                       \
  template std::vector<Pair> overlapping<D>(const kerf::Tree<D>&);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf::test
