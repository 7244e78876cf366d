#include "core/kernels/sort_found.h"

#include <hwy/contrib/sort/vqsort.h>

#include <algorithm>
#include <array>
#include <utility>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/kernels/sort_found.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#ifndef KERF_CORE_KERNELS_SORT_FOUND_ONCE
#define KERF_CORE_KERNELS_SORT_FOUND_ONCE
namespace kerf {

/// Up to so many numbers are sorted by counting: then that takes less time than vqsort, which in
/// Highway 1.0.3 asks the system for random bits each time.
inline constexpr std::size_t kMostCounted = 96;
/// Beyond the numbers, so that two whole vectors can be read and written.
inline constexpr std::size_t kBeyond = 16;

}  // namespace kerf
#endif

HWY_BEFORE_NAMESPACE();
namespace kerf::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// `numbers` has `count` of them, then at least two vectors of the largest that there is.
template <class Number>
HWY_INLINE void count_smaller(const Number* numbers, std::size_t count, Number* sorted) {
  using Signed = hwy::MakeSigned<Number>;
#if HWY_TARGET <= HWY_AVX2 && HWY_ARCH_X86
  constexpr std::size_t kLanes = 32 / sizeof(Number);
#else
  constexpr std::size_t kLanes = 16 / sizeof(Number);
#endif
  static_assert(2 * kLanes <= kBeyond);
  const hn::FixedTag<Signed, kLanes> lanes;
  const auto* const in_order = reinterpret_cast<const Signed*>(numbers);
  for (std::size_t k = 0; k < count; k += 2 * kLanes) {
    const auto first = hn::LoadU(lanes, in_order + k);
    const auto second = hn::LoadU(lanes, in_order + k + kLanes);
    auto below_first = hn::Zero(lanes);
    auto below_second = hn::Zero(lanes);
    for (std::size_t i = 0; i < count; ++i) {  // a true comparison is -1
      const auto other = hn::Set(lanes, in_order[i]);
      below_first = hn::Sub(below_first, hn::VecFromMask(lanes, hn::Gt(first, other)));
      below_second = hn::Sub(below_second, hn::VecFromMask(lanes, hn::Gt(second, other)));
    }
    HWY_ALIGN Signed places[2 * kLanes];
    hn::Store(below_first, lanes, places);
    hn::Store(below_second, lanes, places + kLanes);
    for (std::size_t i = 0; i < 2 * kLanes; ++i) sorted[places[i]] = numbers[k + i];
  }
}

void count_32(const std::uint32_t* numbers, std::size_t count, std::uint32_t* sorted) {
  count_smaller(numbers, count, sorted);
}
void count_64(const std::uint64_t* numbers, std::size_t count, std::uint64_t* sorted) {
  count_smaller(numbers, count, sorted);
}

}  // namespace kerf::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kerf {
namespace {

HWY_EXPORT(count_32);
HWY_EXPORT(count_64);

/// `count(numbers, size, sorted)` writes those beyond the numbers behind them.
template <class Number, class Count>
void sort_numbers(std::span<Number> numbers, Number largest, Count count) {
  if (numbers.size() < 2) return;
  if (numbers.size() == 2) {
    if (numbers[1] < numbers[0]) std::swap(numbers[0], numbers[1]);
    return;
  }
  if (numbers.size() > kMostCounted) {
    thread_local const hwy::Sorter sorter;
    sorter(numbers.data(), numbers.size(), hwy::SortAscending());
    return;
  }
  std::array<Number, kMostCounted + kBeyond> given;  // written before they are read
  std::array<Number, kMostCounted + kBeyond> sorted;
  std::fill_n(std::ranges::copy(numbers, given.begin()).out, kBeyond, largest);
  count(given.data(), numbers.size(), sorted.data());
  std::copy_n(sorted.begin(), numbers.size(), numbers.begin());
}

}  // namespace

void sort_found(std::span<std::uint32_t> numbers) {
  sort_numbers(numbers, std::uint32_t{INT32_MAX}, HWY_DYNAMIC_DISPATCH(count_32));
}

void sort_found(std::span<std::uint64_t> numbers) {
  sort_numbers(numbers, std::uint64_t{INT64_MAX}, HWY_DYNAMIC_DISPATCH(count_64));
}

}  // namespace kerf
#endif
