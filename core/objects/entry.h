#pragma once

#include <cstdint>

#include "core/base/ids.h"
#include "core/geometry/plane.h"

namespace kerf {

/// Bits per ancestor: bit k stands for the ancestor at depth k. The root has depth 0.
using DepthMask = std::uint64_t;
inline constexpr std::uint32_t kMaxHeight = 63;

constexpr DepthMask depth_bit(std::uint32_t depth) { return DepthMask{1} << depth; }
/// The bits of the ancestors above `depth`.
constexpr DepthMask bits_above(std::uint32_t depth) { return depth_bit(depth) - 1; }

#pragma pack(push, 4)  // 20 bytes, not 24; so no reference to the mask: it may not be aligned
/// One object stored in one leaf.
struct Entry {
  Interval key;  ///< projection on the leaf's direction
  ObjectId object;
  DepthMask straddle = 0;  ///< bit k: the object is stored on both sides of the ancestor at depth k
};
#pragma pack(pop)

}  // namespace kerf
