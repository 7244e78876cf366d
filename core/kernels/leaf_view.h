#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "core/base/list_room.h"
#include "core/geometry/packed_box.h"
#include "core/objects/entry.h"

namespace kerf {

/// The bytes of an entry, the lowest first: min of each axis in the first half, max in the second.
template <int D>
using ByteKey = std::conditional_t<D == 2, std::uint32_t, std::uint64_t>;

/// The monotone map of a leaf's axes to bytes: `round(clamp((x - origin) * scale, 0, 255))`. What lies below
/// the least end of a box, or above the greatest beginning, overlaps in any case, so only the stretch between
/// needs different values; what lies far beyond nearly all boxes shares one, too, and floats decide. Each
/// axis has a number for min, and its negative for -max: negation commutes with the map, to the last bit.
template <int D>
struct ByteScale {
  PackedBox<D> origin;
  PackedBox<D> scale;
};

/// The arrays that the sweep of a leaf reads, entry by entry.
///
/// `apart` is the exclusion mask: the bits of the planes that an entry straddles and that the leaf lies right
/// of, and `kFixedBit` for a fixed object. Two entries are this leaf's pair iff their masks have no common
/// bit (DESIGN.md, "Each pair once"; two fixed objects are never a pair).
template <int D>
struct LeafView {
  static constexpr DepthMask kFixedBit = DepthMask{1} << 63U;  // no ancestor lies that deep
  std::vector<PackedBox<D>> boxes;
  std::vector<ObjectId> objects;
  std::vector<DepthMask> apart;

  [[nodiscard]] std::size_t size() const { return objects.size(); }
  void resize(std::size_t n) {
    resize_list(boxes, n);
    resize_list(objects, n);
    resize_list(apart, n);
  }
};

}  // namespace kerf
