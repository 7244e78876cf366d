#include "core/kernels/radix_sort.h"

#include <array>

#include "core/kernels/sweep_tuning.h"

namespace kerf {
namespace {

template <unsigned Bits>
constexpr std::size_t digit(std::uint32_t key, std::size_t pass) {
  return (key >> (Bits * static_cast<unsigned>(pass))) & ((std::size_t{1} << Bits) - 1);
}

/// Turns counts into places; false if all keys have the same digit.
template <std::size_t Buckets>
bool to_places(std::array<std::uint32_t, Buckets>& counts, std::size_t size) {
  std::uint32_t place = 0;
  for (std::uint32_t& count : counts) {
    if (count == size) return false;
    place += count;
    count = place - count;
  }
  return true;
}

/// In as many passes as take all 32 bits.
template <unsigned Bits>
void sort_by_digits(std::vector<RadixSort::Item>& items, std::vector<RadixSort::Item>& other) {
  constexpr std::size_t kPasses = (32 + Bits - 1) / Bits;
  std::array<std::array<std::uint32_t, std::size_t{1} << Bits>, kPasses> counts{};
  for (const RadixSort::Item& item : items)
    for (std::size_t pass = 0; pass < kPasses; ++pass) ++counts[pass][digit<Bits>(item.key, pass)];
  for (std::size_t pass = 0; pass < kPasses; ++pass) {
    if (!to_places(counts[pass], items.size())) continue;
    for (const RadixSort::Item& item : items) other[counts[pass][digit<Bits>(item.key, pass)]++] = item;
    items.swap(other);
  }
}

}  // namespace

void RadixSort::sort() {
  other_.resize(items.size());
  if (items.size() < tuning::kLeastLongDigits) {
    sort_by_digits<8>(items, other_);
  } else {
    sort_by_digits<11>(items, other_);
  }
}

}  // namespace kerf
