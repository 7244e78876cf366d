#include "core/query/compare_trees.h"

#include <algorithm>
#include <bit>
#include <map>

namespace kerf {
namespace {

using Of = CommonNumbers::Of;

bool same_bits(Scalar x, Scalar y) {
  return std::bit_cast<std::uint32_t>(x) == std::bit_cast<std::uint32_t>(y);
}

bool same_entries(const std::vector<Entry>& a, const std::vector<Entry>& b, CommonNumbers& numbers) {
  return std::ranges::equal(a, b, [&](const Entry& x, const Entry& y) {
    return same_bits(x.key.lo, y.key.lo) && same_bits(x.key.hi, y.key.hi) && x.straddle == y.straddle &&
           numbers(Of::a, x.object) == numbers(Of::b, y.object);
  });
}

template <int D>
bool same_nodes(const Tree<D>& a, const Tree<D>& b, CommonNumbers& numbers) {
  const auto list = [](const Tree<D>& tree) {
    std::vector<NodeId> nodes;
    for_each_node(tree, tree.root(), [&](NodeId id) { nodes.push_back(id); });
    return nodes;
  };
  return std::ranges::equal(list(a), list(b), [&](NodeId id, NodeId other) {
    const Node<D>& x = a[id];
    const Node<D>& y = b[other];
    if (id != other || x.generation != y.generation || x.direction != y.direction ||
        x.population != y.population || x.retry_step != y.retry_step || x.refusals != y.refusals ||
        x.is_leaf() != y.is_leaf())
      return false;
    return x.is_leaf() ? same_entries(x.entries, y.entries, numbers)
                       : same_bits(x.plane.offset, y.plane.offset);
  });
}

/// Those that are there, by their common numbers.
template <int D>
std::map<ObjectId, ObjectId> objects_of(const ObjectTable<D>& table, Of of, CommonNumbers& numbers) {
  std::map<ObjectId, ObjectId> objects;
  for (std::uint32_t id = 0; id < table.bound(); ++id)
    if (table.state({id}) != ObjectState::absent) objects.emplace(numbers(of, {id}), ObjectId{id});
  return objects;
}

template <int D>
bool same_object(const ObjectTable<D>& a, ObjectId x, const ObjectTable<D>& b, ObjectId y) {
  if (a.state(x) != b.state(y) || a.is_fixed(x) != b.is_fixed(y)) return false;
  if (!a.is_placed(x)) return true;
  for (int axis = 0; axis < D; ++axis)
    if (!same_bits(a.box(x).min[axis], b.box(y).min[axis]) ||
        !same_bits(a.box(x).max[axis], b.box(y).max[axis]))
      return false;
  const auto extra = static_cast<std::size_t>(extra_size<D>(a.kind()));
  return a.kind() == b.kind() && std::equal(a.extra(x), a.extra(x) + extra, b.extra(y), same_bits);
}

template <int D>
bool same_objects(const ObjectTable<D>& a, const ObjectTable<D>& b, CommonNumbers& numbers) {
  return std::ranges::equal(objects_of(a, Of::a, numbers), objects_of(b, Of::b, numbers),
                            [&](const auto& x, const auto& y) {
                              return x.first == y.first && same_object(a, x.second, b, y.second);
                            });
}

}  // namespace

template <int D>
bool same_trees(const BspState<D>& a, const BspState<D>& b, CommonNumbers& numbers) {
  return a.scheduler.mix_into(0) == b.scheduler.mix_into(0) && same_nodes(a.tree, b.tree, numbers) &&
         same_objects(a.tree.table, b.tree.table, numbers);
}

template bool same_trees<2>(const BspState<2>&, const BspState<2>&, CommonNumbers&);
template bool same_trees<3>(const BspState<3>&, const BspState<3>&, CommonNumbers&);

}  // namespace kerf
