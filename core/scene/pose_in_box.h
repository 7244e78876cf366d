#pragma once

#include <array>
#include <optional>

#include "core/geometry/box.h"
#include "core/scene/shape.h"

namespace kerf {

/// Where a shape that is turned like this stands if `box` is its box: the middle of the shape's own box is
/// the middle of `box`. None if the shape is larger than the box, by more than the rounding of the axes and
/// of the box explain, or if the box is not finite.
template <int D>
std::optional<Pose<D>> pose_in_box(const Shape<D>& shape, const std::array<Vector<D>, D>& axes,
                                   const Box<D>& box);

}  // namespace kerf
