#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>

#include "core/base/bytes.h"
#include "core/base/damage.h"

namespace kerf {

/// Appends numbers of up to 32 bits each, without gaps.
class BitWriter {
 public:
  /// All bits of `x` at or above `bits` are 0.
  void put(std::uint32_t x, unsigned bits) {
    pending_ |= std::uint64_t{x} << held_;
    held_ += bits;
    if (held_ >= 32) write(4);
  }
  /// All bytes, the last one filled up with zeros. Begins anew.
  Bytes take() {
    write((held_ + 7) / 8);
    pending_ = 0;
    held_ = 0;
    return std::exchange(bytes_, {});
  }

 private:
  /// Writes the lowest pending bytes, several at a time: the number due after each value is a branch that
  /// nothing predicts.
  void write(unsigned count) {
    for (unsigned k = 0; k < count; ++k) bytes_.push_back(static_cast<std::uint8_t>(pending_ >> 8 * k));
    pending_ >>= 8 * count;
    held_ -= std::min(held_, 8 * count);
  }

  Bytes bytes_;
  std::uint64_t pending_ = 0;
  unsigned held_ = 0;  ///< bits in pending_, less than 32 between calls
};

/// Reads what BitWriter wrote. Throws std::runtime_error where the bytes end too soon.
class BitReader {
 public:
  explicit BitReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  std::uint32_t get(unsigned bits) {
    for (; held_ < bits; held_ += 8) {
      if (next_ == bytes_.size()) fail_damaged("bits are missing");
      pending_ |= std::uint64_t{bytes_[next_++]} << held_;
    }
    const auto x = static_cast<std::uint32_t>(pending_ & ((std::uint64_t{1} << bits) - 1));
    pending_ >>= bits;
    held_ -= bits;
    return x;
  }
  /// Whether everything was read except the zeros that fill up the last byte.
  [[nodiscard]] bool empty() const { return next_ == bytes_.size() && held_ < 8 && pending_ == 0; }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t next_ = 0;
  std::uint64_t pending_ = 0;
  unsigned held_ = 0;
};

}  // namespace kerf
