#include "viz/draw/crowds.h"

#include <algorithm>

#include "viz/draw/draw_context.h"

namespace kerf {
namespace {

constexpr Scalar kRoom = 0.02F;  ///< around the objects, as a share of the longest side of the bounds

template <int D>
Box<D> with_room(Box<D> box, const Box<D>& bounds, Scalar room) {
  if (box.min[0] > box.max[0]) return bounds;
  for (int i = 0; i < D; ++i) {
    box.min[i] = std::max(bounds.min[i], box.min[i] - room);
    box.max[i] = std::min(bounds.max[i], box.max[i] + room);
  }
  return box;
}

}  // namespace

template <int D>
std::vector<Box<D>> find_crowds(const Tree<D>& tree, std::span<const Body<D>> bodies, const Box<D>& bounds) {
  std::vector<Box<D>> crowds(tree.slots(), Box<D>::empty());
  std::vector<NodeId> order;  // parents before their children
  for_each_node(tree, tree.root(), [&](NodeId id) {
    order.push_back(id);
    for (const Entry& entry : tree[id].entries) {
      const std::size_t object = entry.object.index();
      if (object < bodies.size() && is_drawable(bodies[object]))
        crowds[id.index()] = join(crowds[id.index()], bodies[object].box);
    }
  });
  std::ranges::reverse(order);
  for (const NodeId id : order) {
    const NodeId parent = tree[id].parent;
    if (!parent.is_none()) crowds[parent.index()] = join(crowds[parent.index()], crowds[id.index()]);
  }
  const Vector<D> extent = bounds.extent();
  const Scalar room = kRoom * *std::ranges::max_element(extent.value);
  for (const NodeId id : order) crowds[id.index()] = with_room(crowds[id.index()], bounds, room);
  return crowds;
}

template std::vector<Box<2>> find_crowds(const Tree<2>&, std::span<const Body<2>>, const Box<2>&);
template std::vector<Box<3>> find_crowds(const Tree<3>&, std::span<const Body<3>>, const Box<3>&);

}  // namespace kerf
