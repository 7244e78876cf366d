#include "core/tree/cell.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kerf {

namespace {

/// Objects that begin here or later lie right of the offset, also on a processor that takes denormals for
/// zero. A denormal is never a bound, since it would admit objects that begin at zero, not beyond the offset.
Scalar right_bound(Scalar offset) {
  constexpr Scalar kLeast = std::numeric_limits<Scalar>::min();
  if (-kLeast < offset && offset < kLeast) return kLeast;
  return std::nextafter(offset, std::numeric_limits<Scalar>::infinity());
}

}  // namespace

template <int D>
PackedBox<D> cell_of(const Tree<D>& tree, NodeId leaf) {
  constexpr Scalar kInfinity = std::numeric_limits<Scalar>::infinity();
  PackedBox<D> cell;
  cell.lane.fill(-kInfinity);
  for (NodeId id = tree[leaf].parent; !id.is_none(); id = tree[id].parent) {
    const Node<D>& node = tree[id];
    if (node.direction >= D) {
      cell.lane.fill(kInfinity);
      break;
    }
    const bool right = (tree[leaf].right_of & depth_bit(node.depth)) != 0;
    const std::size_t lane = right ? node.direction : PackedBox<D>::kHalf + node.direction;
    const Scalar bound = right ? right_bound(node.plane.offset) : -node.plane.offset;
    cell.lane[lane] = std::max(cell.lane[lane], bound);
  }
  return cell;
}

template PackedBox<2> cell_of<2>(const Tree<2>&, NodeId);
template PackedBox<3> cell_of<3>(const Tree<3>&, NodeId);

}  // namespace kerf
