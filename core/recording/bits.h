#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <utility>

#include "core/recording/bytes.h"

namespace kerf {

/// Appends numbers of up to 32 bits each, without gaps.
class BitWriter {
 public:
  /// `x` has no bit at or above `bits`.
  void put(std::uint32_t x, unsigned bits) {
    pending_ |= std::uint64_t{x} << held_;
    held_ += bits;
    for (; held_ >= 8; held_ -= 8, pending_ >>= 8U) bytes_.push_back(static_cast<std::uint8_t>(pending_));
  }
  /// All bytes; the last one is filled up with zeros. Begins anew.
  Bytes take() {
    if (held_ > 0) bytes_.push_back(static_cast<std::uint8_t>(pending_));
    pending_ = 0;
    held_ = 0;
    return std::exchange(bytes_, {});
  }

 private:
  Bytes bytes_;
  std::uint64_t pending_ = 0;
  unsigned held_ = 0;  ///< bits in pending_, less than 8 between calls
};

/// Reads what BitWriter wrote. Throws std::runtime_error where the bytes end too soon.
class BitReader {
 public:
  explicit BitReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  std::uint32_t get(unsigned bits) {
    for (; held_ < bits; held_ += 8) {
      if (next_ == bytes_.size()) throw std::runtime_error("the recording is damaged: bits are missing");
      pending_ |= std::uint64_t{bytes_[next_++]} << held_;
    }
    const auto x = static_cast<std::uint32_t>(pending_ & ((std::uint64_t{1} << bits) - 1));
    pending_ >>= bits;
    held_ -= bits;
    return x;
  }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t next_ = 0;
  std::uint64_t pending_ = 0;
  unsigned held_ = 0;
};

}  // namespace kerf
