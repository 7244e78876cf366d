#pragma once

#include <cstddef>
#include <cstdint>

#include "core/geometry/plane.h"
#include "core/objects/entry.h"

namespace kerf {

/// A list of objects that a node divides for its children by an axis of the packed boxes: those on the left
/// stay in place, those on the right go behind the list. Both arrays must have kDividePad more places than
/// could be needed.
struct DivideJob {
  const Scalar* lo = nullptr;        ///< of object 0: its least coordinate on the axis
  const Scalar* minus_hi = nullptr;  ///< and its greatest, negative
  Scalar offset = 0;                 ///< of the partitioner
  DepthMask bit = 0;                 ///< the bit that straddlers get
  std::uint32_t* objects = nullptr;
  DepthMask* straddle = nullptr;
  std::size_t begin = 0;
  std::size_t end = 0;
  bool far = false;  ///< boxes are prefetched
};

inline constexpr std::size_t kDividePad = 64;

/// How far a list is divided: up to `done`; the parts end at `left` and `right`.
struct Divided {
  std::size_t done = 0;
  std::size_t left = 0;
  std::size_t right = 0;
};

/// Divides, in order and as `classify` does, as many objects as fill whole vectors. The caller divides the
/// rest.
template <int D>
Divided divide_list(const DivideJob& job);

}  // namespace kerf
