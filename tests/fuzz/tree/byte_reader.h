#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/geometry/vector.h"

namespace kerf::test {

/// Hands out the bytes of a fuzz case one by one; zeros when they are spent.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  [[nodiscard]] bool is_spent() const { return next_ >= bytes_.size(); }
  std::uint8_t byte() { return is_spent() ? std::uint8_t{0} : bytes_[next_++]; }
  /// A number below `bound`, which is not 0.
  std::uint32_t below(std::uint32_t bound) {
    const std::uint32_t high = bound > 256 ? byte() : 0U;
    return ((high << 8U) | byte()) % bound;
  }
  /// Any float there is.
  Scalar any_scalar() {
    std::uint32_t bits = 0;
    for (int i = 0; i < 4; ++i) bits = (bits << 8U) | byte();
    return std::bit_cast<Scalar>(bits);
  }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t next_ = 0;
};

}  // namespace kerf::test
