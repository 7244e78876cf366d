#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/geometry/vector.h"

namespace kerf {

/// An object on its way into a block.
template <int D>
struct CenteredObject {
  Vector<D> center;  ///< of its box
  std::uint32_t object = 0;
};

/// The axis along which the centres extend farthest; of at least one object.
template <int D>
int longest_axis(std::span<const CenteredObject<D>> objects);

/// Reorders the objects: the first `count` are those with the least centres on the axis, of equal centres
/// those with the least ids. `count` is less than their number.
template <int D>
void divide_objects(std::span<CenteredObject<D>> objects, std::size_t count, int axis);

}  // namespace kerf
