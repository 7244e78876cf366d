#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/damage.h"

namespace kerf {

using Bytes = std::vector<std::uint8_t>;

/// Small numbers in few bytes: the sign goes to the lowest bit.
constexpr std::uint32_t zigzag(std::int32_t x) {
  return (static_cast<std::uint32_t>(x) << 1U) ^ static_cast<std::uint32_t>(x >> 31);
}
constexpr std::int32_t unzigzag(std::uint32_t x) {
  return static_cast<std::int32_t>((x >> 1U) ^ (~(x & 1U) + 1U));
}

/// Appends numbers to bytes: as they are in little-endian order, or as varints of seven bits a byte.
class ByteWriter {
 public:
  void u8(std::uint8_t x) { bytes_.push_back(x); }
  void u32(std::uint32_t x) { fixed(x, 4); }
  void u64(std::uint64_t x) { fixed(x, 8); }
  void f32(float x) { u32(std::bit_cast<std::uint32_t>(x)); }
  void varint(std::uint64_t x) {
    for (; x >= 0x80; x >>= 7U) u8(static_cast<std::uint8_t>(x | 0x80U));
    u8(static_cast<std::uint8_t>(x));
  }
  /// The length, then the bytes.
  void blob(std::span<const std::uint8_t> bytes) {
    varint(bytes.size());
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
  }
  void text(std::string_view text) {
    varint(text.size());
    bytes_.insert(bytes_.end(), text.begin(), text.end());
  }

  [[nodiscard]] std::span<const std::uint8_t> bytes() const { return bytes_; }
  void clear() { bytes_.clear(); }

 private:
  void fixed(std::uint64_t x, std::size_t size) {
    const std::size_t at = bytes_.size();
    bytes_.resize(at + size);
    for (std::size_t i = 0; i < size; ++i) bytes_[at + i] = static_cast<std::uint8_t>(x >> 8 * i);
  }

  Bytes bytes_;
};

/// Reads what ByteWriter wrote. Throws std::runtime_error where the bytes end too soon.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::uint8_t> bytes) : rest_(bytes) {}

  std::uint8_t u8() { return take(1)[0]; }
  std::uint32_t u32() { return static_cast<std::uint32_t>(fixed(4)); }
  std::uint64_t u64() { return fixed(8); }
  float f32() { return std::bit_cast<float>(u32()); }
  std::uint64_t varint() {
    std::uint64_t x = 0;
    for (unsigned shift = 0; shift < 64; shift += 7) {
      const std::uint8_t byte = u8();
      x |= static_cast<std::uint64_t>(byte & 0x7FU) << shift;
      if (byte < 0x80) return x;
    }
    fail_damaged("a number does not end");
  }
  /// A varint of at most 32 bits.
  std::uint32_t number() {
    const std::uint64_t x = varint();
    if (x > UINT32_MAX) fail_damaged("a number has more than 32 bits");
    return static_cast<std::uint32_t>(x);
  }
  /// A byte less than `end`: a name of so many, 2 for a flag.
  std::uint8_t choice(std::uint8_t end) {
    const std::uint8_t x = u8();
    if (x >= end) fail_damaged("a choice of " + std::to_string(end) + " is " + std::to_string(x));
    return x;
  }
  /// A varint that counts things of at least `size` bytes each: never more than there are bytes left for.
  std::size_t count(std::size_t size = 1) {
    const std::uint64_t x = varint();
    if (x > rest_.size() / size) fail_damaged("a list is longer than its block");
    return static_cast<std::size_t>(x);
  }
  std::span<const std::uint8_t> blob() { return take(count()); }
  [[nodiscard]] bool empty() const { return rest_.empty(); }
  /// How many bytes have not been read.
  [[nodiscard]] std::size_t left() const { return rest_.size(); }

 private:
  std::span<const std::uint8_t> take(std::size_t size) {
    if (size > rest_.size()) fail_damaged("a block ends too soon");
    const auto taken = rest_.first(size);
    rest_ = rest_.subspan(size);
    return taken;
  }
  std::uint64_t fixed(std::size_t size) {
    std::uint64_t x = 0;
    const auto bytes = take(size);
    for (std::size_t i = size; i > 0; --i) x = (x << 8U) | bytes[i - 1];
    return x;
  }

  std::span<const std::uint8_t> rest_;
};

}  // namespace kerf
