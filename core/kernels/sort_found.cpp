#include "core/kernels/sort_found.h"

#include <hwy/contrib/sort/vqsort.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "core/base/sample_place.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/kernels/sort_found.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#ifndef KERF_CORE_KERNELS_SORT_FOUND_ONCE
#define KERF_CORE_KERNELS_SORT_FOUND_ONCE
namespace kerf {

/// Up to so many numbers are sorted by counting, and up to so many are divided until they are as few: then
/// that takes less time than vqsort, which in Highway 1.0.3 asks the system for random bits each time.
inline constexpr std::size_t kMostCounted = 96;
inline constexpr std::size_t kMostDivided = 1024;
/// Beyond the numbers, so that two whole vectors can be read and written.
inline constexpr std::size_t kBeyond = 32;

}  // namespace kerf
#endif

HWY_BEFORE_NAMESPACE();
namespace kerf::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Adds one in the lanes where it is true.
template <class Lanes>
HWY_INLINE hn::Vec<Lanes> count_true(Lanes lanes, hn::Vec<Lanes> counts, hn::Mask<Lanes> where) {
#if HWY_TARGET <= HWY_AVX3 && HWY_ARCH_X86
  return hn::IfThenElse(where, hn::Add(counts, hn::Set(lanes, 1)), counts);
#else  // a true comparison is -1
  return hn::Sub(counts, hn::VecFromMask(lanes, where));
#endif
}

/// In vectors of so many bytes. `numbers` has `count` of them, then at least two vectors of the largest that
/// there is.
template <std::size_t Bytes, class Number>
HWY_INLINE void count_smaller(const Number* numbers, std::size_t count, Number* sorted) {
  using Signed = hwy::MakeSigned<Number>;
  constexpr std::size_t kLanes = Bytes / sizeof(Number);
  static_assert(2 * kLanes <= kBeyond);
  const hn::FixedTag<Signed, kLanes> lanes;
  const auto* const in_order = reinterpret_cast<const Signed*>(numbers);
  for (std::size_t k = 0; k < count; k += 2 * kLanes) {
    const auto first = hn::LoadU(lanes, in_order + k);
    const auto second = hn::LoadU(lanes, in_order + k + kLanes);
    auto below_first = hn::Zero(lanes);
    auto below_second = hn::Zero(lanes);
    for (std::size_t i = 0; i < count; ++i) {
      const auto other = hn::Set(lanes, in_order[i]);
      below_first = count_true(lanes, below_first, hn::Gt(first, other));
      below_second = count_true(lanes, below_second, hn::Gt(second, other));
    }
    HWY_ALIGN Signed places[2 * kLanes];
    hn::Store(below_first, lanes, places);
    hn::Store(below_second, lanes, places + kLanes);
    for (std::size_t i = 0; i < 2 * kLanes; ++i) sorted[places[i]] = numbers[k + i];
  }
}

/// The widest vectors that are not mostly empty.
template <class Number>
HWY_INLINE void count_in_vectors(const Number* numbers, std::size_t count, Number* sorted) {
#if HWY_TARGET <= HWY_AVX3 && HWY_ARCH_X86
  count > 64 / sizeof(Number) ? count_smaller<64>(numbers, count, sorted)
                              : count_smaller<32>(numbers, count, sorted);
#elif HWY_TARGET <= HWY_AVX2 && HWY_ARCH_X86
  count_smaller<32>(numbers, count, sorted);
#else
  count_smaller<16>(numbers, count, sorted);
#endif
}

void count_32(const std::uint32_t* numbers, std::size_t count, std::uint32_t* sorted) {
  count_in_vectors(numbers, count, sorted);
}
void count_64(const std::uint64_t* numbers, std::size_t count, std::uint64_t* sorted) {
  count_in_vectors(numbers, count, sorted);
}

}  // namespace kerf::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kerf {
namespace {

HWY_EXPORT(count_32);
HWY_EXPORT(count_64);

template <class Number>
void sort_many(std::span<Number> numbers) {
  thread_local const hwy::Sorter sorter;
  sorter(numbers.data(), numbers.size(), hwy::SortAscending());
}

/// `count(numbers, size, sorted)` writes those beyond the numbers behind them.
template <class Number, class Count>
void sort_few(std::span<Number> numbers, Number largest, Count count) {
  if (numbers.size() < 2) return;
  if (numbers.size() == 2) {
    if (numbers[1] < numbers[0]) std::swap(numbers[0], numbers[1]);
    return;
  }
  std::array<Number, kMostCounted + kBeyond> given;  // written before they are read
  std::array<Number, kMostCounted + kBeyond> sorted;
  std::fill_n(std::ranges::copy(numbers, given.begin()).out, kBeyond, largest);
  count(given.data(), numbers.size(), sorted.data());
  std::copy_n(sorted.begin(), numbers.size(), numbers.begin());
}

template <class Number>
Number median(Number a, Number b, Number c) {
  return std::max(std::min(a, b), std::min(std::max(a, b), c));
}

/// The median of three medians of three.
template <class Number>
Number choose_pivot(std::span<const Number> numbers) {
  std::array<Number, 9> sample;
  for (std::uint32_t k = 0; k < sample.size(); ++k) sample[k] = numbers[sample_place(k, numbers.size())];
  for (std::size_t k = 0; k < 9; k += 3) sample[k] = median(sample[k], sample[k + 1], sample[k + 2]);
  return median(sample[0], sample[3], sample[6]);
}

/// Moves the numbers below the pivot to the front; returns how many there are. No branch depends on them.
template <class Number>
std::size_t move_to_front(std::span<Number> numbers, Number pivot) {
  std::array<Number, kMostDivided> others;  // written before they are read
  std::size_t below = 0;
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const Number number = numbers[k];
    numbers[below] = number;
    others[k - below] = number;
    below += number < pivot ? 1 : 0;
  }
  std::copy_n(others.begin(), numbers.size() - below, numbers.begin() + static_cast<std::ptrdiff_t>(below));
  return below;
}

/// All numbers differ.
template <class Number, class Count>
void sort_numbers(std::span<Number> numbers, Number largest, Count count) {
  if (numbers.size() > kMostDivided) return sort_many(numbers);
  while (numbers.size() > kMostCounted) {
    const std::size_t below = move_to_front(numbers, choose_pivot(std::span<const Number>(numbers)));
    if (std::max(below, numbers.size() - below) > numbers.size() / 8 * 7) return sort_many(numbers);
    sort_numbers(numbers.first(below), largest, count);
    numbers = numbers.subspan(below);
  }
  sort_few(numbers, largest, count);
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
