#pragma once

#include <optional>

#include "core/bsp/requests.h"
#include "core/geometry/vector.h"
#include "core/tree/tree.h"

namespace kerf {

/// The vector by which the objects of a world moved since the last step, if nearly all of them moved alike
/// and nearly as far as they are large: the origin was moved. Beside it they may move by an eighth of their
/// size, or by all of it if the way is eight times as long. A sample decides; a mistake costs time, never a
/// pair. None for volumes that are not boxes.
template <int D>
std::optional<Vector<D>> common_motion(const Requests<D>& requests, const ObjectTable<D>& placed, bool keeps);

/// Moves all partitioners by the vector. Entries are wrong until all objects are placed anew.
template <int D>
void shift_planes(Tree<D>& tree, const Vector<D>& by);

/// Where the partitioner's offset goes by the vector.
template <int D>
Scalar shifted_offset(const Plane<D>& plane, const Vector<D>& by) {
  return plane.offset + dot(plane.normal, by);
}

}  // namespace kerf
