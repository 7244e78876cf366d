#pragma once

#include <cstddef>
#include <cstdint>

#include "core/geometry/packed_box.h"
#include "core/objects/entry.h"

namespace kerf {

/// The entries of a leaf, and how the objects' boxes are now.
template <int D>
struct StayJob {
  const PackedBox<D>* boxes = nullptr;  ///< by object
  PackedBox<D> cell;                    ///< closed: what lies in it reaches no other leaf
  DepthMask right_of = 0;               ///< of the leaf
  std::uint32_t axis = 0;               ///< of the leaf's list
  Entry* entries = nullptr;
  std::size_t count = 0;
  std::uint32_t* leavers = nullptr;      ///< room for `count`
  PackedBox<D>* leaver_boxes = nullptr;  ///< room for `count`; none: no boxes are wanted
  PackedBox<D>* stayer_boxes = nullptr;  ///< likewise
};

struct Stayed {
  std::size_t stayed = 0;
  std::size_t left = 0;
};

/// Keeps the entries of objects that straddle nothing and lie in the cell, in order and with new keys, and
/// lists the other objects. One that straddles is listed only by the leftmost of its leaves. Boxes of both
/// are copied if they are wanted.
template <int D>
Stayed stay_in_cell(const StayJob<D>& job);

}  // namespace kerf
