#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/append_buffer.h"
#include "core/base/list_room.h"
#include "core/kernels/radix_sort.h"
#include "core/objects/entry.h"

namespace kerf {

/// The memory of a sweep of one leaf by vectors of floats, kept between leaves: for boxes that no bytes
/// separate.
struct FloatSweep {
  static constexpr std::size_t kPad = 64;  ///< floats that may be read beyond the end of a plane
  RadixSort order;                         ///< the places of the entries in the view, in order
  std::vector<std::uint32_t> objects;      ///< of the entries in order
  std::vector<DepthMask> apart;            ///< exclusion masks in order
  std::vector<std::uint8_t> folded;        ///< the same, folded to a byte each
  bool folds_decide = false;               ///< no two bits in use fall on the same one
  std::vector<std::uint32_t> others;       ///< those of one entry's pairs
  PairBuffer excluded;                     ///< pairs whose masks are looked at
  std::vector<Scalar> planes;              ///< ends in order: of each axis min, then max
  std::size_t stride = 0;

  [[nodiscard]] Scalar* plane(std::size_t k) { return planes.data() + k * stride; }
  void make_room(std::size_t n, std::size_t count) {
    stride = n + kPad;
    if (planes.size() < stride * count) resize_list(planes, stride * count);
    resize_list(objects, n + kPad);
    resize_list(apart, n);
    resize_list(folded, n + kPad);
    resize_list(others, n + 2 * kPad);
  }
};

}  // namespace kerf
