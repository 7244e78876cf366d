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
std::optional<Vector<D>> common_motion(const Requests<D>& requests, const ObjectTable<D>& tree, bool keeps);

/// Moves all partitioners by the vector. Entries are wrong until all objects are placed anew.
template <int D>
void shift_planes(Tree<D>& tree, const Vector<D>& by);

/// The box moved by the vector, as floats round.
template <int D>
Box<D> shifted(const Box<D>& box, const Vector<D>& by) {
  return {box.min + by, box.max + by};
}

}  // namespace kerf
