#include "core/kernels/radix_sort.h"

#include <array>

namespace kerf {
namespace {

constexpr unsigned kBits = 11;  // three passes take all 32 bits
constexpr std::size_t kBuckets = std::size_t{1} << kBits;
constexpr std::size_t kPasses = 3;

using Counts = std::array<std::array<std::uint32_t, kBuckets>, kPasses>;

constexpr std::size_t digit(std::uint32_t key, std::size_t pass) {
  return (key >> (kBits * static_cast<unsigned>(pass))) & (kBuckets - 1);
}

/// Turns counts into places; false if all keys have the same digit.
bool to_places(std::array<std::uint32_t, kBuckets>& counts, std::size_t size) {
  std::uint32_t place = 0;
  for (std::uint32_t& count : counts) {
    if (count == size) return false;
    place += count;
    count = place - count;
  }
  return true;
}

}  // namespace

void RadixSort::sort() {
  other_.resize(items.size());
  Counts counts{};
  for (const Item& item : items)
    for (std::size_t pass = 0; pass < kPasses; ++pass) ++counts[pass][digit(item.key, pass)];
  for (std::size_t pass = 0; pass < kPasses; ++pass) {
    if (!to_places(counts[pass], items.size())) continue;
    for (const Item& item : items) other_[counts[pass][digit(item.key, pass)]++] = item;
    items.swap(other_);
  }
}

}  // namespace kerf
