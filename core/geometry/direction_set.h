#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/vector.h"

namespace kerf {

/// Directions spread evenly over the hemisphere (half circle in 2D) of partitioner normals by point repulsion
/// (paper section 3.2, after Hasan et al. 2001). The first D are the axes, exactly; the rest are ordered so
/// that every prefix is spread as evenly as it can be. The same size and seed give the same floats on every
/// machine.
template <int D>
class DirectionSet {
 public:
  /// Throws std::invalid_argument if `size` is below D or above 4096.
  DirectionSet(std::uint32_t size, std::uint64_t seed);
  /// The axes, then the given directions as they are: they need not have length one nor differ. Throws
  /// std::invalid_argument for one that is zero, NaN or has a component beyond [-1, 1].
  explicit DirectionSet(std::span<const Vector<D>> directions);

  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(directions_.size()); }
  [[nodiscard]] const Vector<D>& operator[](std::uint32_t index) const { return directions_[index]; }
  [[nodiscard]] std::span<const Vector<D>> all() const { return directions_; }

 private:
  std::vector<Vector<D>> directions_;
};

}  // namespace kerf
