#include "core/kernels/box_rows.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/kernels/box_rows.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace kerf::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET <= HWY_AVX3 && HWY_ARCH_X86
constexpr std::size_t kBytes = 64;
#elif HWY_TARGET <= HWY_AVX2 && HWY_ARCH_X86
constexpr std::size_t kBytes = 32;
#else
constexpr std::size_t kBytes = 16;
#endif

/// Rows that fill whole vectors, whatever their dimension.
template <class Number>
constexpr std::size_t kTogether = std::max<std::size_t>(4, kBytes / sizeof(Number) / 2);

template <class Number>
using LanesOf = hn::FixedTag<Number, kBytes / sizeof(Number)>;
using Doubles = LanesOf<double>;
using Halves = hn::FixedTag<float, kBytes / sizeof(double)>;
using HalfWords = hn::RebindToSigned<Halves>;

/// For each number of `kTogether` rows, whether it is at most the one D behind it. What that says of upper
/// ends means nothing.
template <int D, class Number>
class InOrder {
 public:
  static constexpr std::size_t kNumbers = kTogether<Number> * 2 * D;
  static constexpr std::size_t kLanes = kBytes / sizeof(Number);
  static constexpr std::size_t kParts = kNumbers / kLanes;
  static_assert(kNumbers % kLanes == 0);

  HWY_INLINE InOrder() {
    for (auto& part : part_) part = hn::VecFromMask(kTag, hn::FirstN(kTag, kLanes));
  }
  HWY_INLINE void add(const Number* rows) {
    for (std::size_t k = 0; k < kParts; ++k) {
      const auto in_order =
          hn::Le(hn::LoadU(kTag, rows + k * kLanes), hn::LoadU(kTag, rows + k * kLanes + D));
      part_[k] = hn::And(part_[k], hn::VecFromMask(kTag, in_order));
    }
  }
  [[nodiscard]] HWY_INLINE bool all() const {
    Number in_order[kNumbers];
    for (std::size_t k = 0; k < kParts; ++k) hn::StoreU(part_[k], kTag, in_order + k * kLanes);
    bool all = true;
    for (std::size_t k = 0; k < kNumbers; ++k)
      if (k % (2 * D) < D) all &= in_order[k] != 0;  // all ones are NaN
    return all;
  }

 private:
  static constexpr LanesOf<Number> kTag{};
  hn::Vec<LanesOf<Number>> part_[kParts];
};

template <int D, class Number>
HWY_INLINE bool is_box(const Number* row) {
  bool all = true;
  for (std::size_t i = 0; i < D; ++i) all &= row[i] <= row[i + D];
  return all;
}

/// Calls `each(row)` for the first of `kTogether` rows, as long as another row follows, since these are read
/// beyond their end; then `rest(row)` for each of the others. Returns whether all are boxes.
template <int D, class Number, class Each, class Rest>
HWY_INLINE bool for_rows(const Number* rows, std::size_t count, Each each, Rest rest) {
  InOrder<D, Number> in_order;
  std::size_t row = 0;
  for (; row + kTogether<Number> < count; row += kTogether<Number>) {
    in_order.add(rows + row * 2 * D);
    each(row);
  }
  bool all = in_order.all();
  for (; row < count; ++row) {
    all &= is_box<D>(rows + row * 2 * D);
    rest(row);
  }
  return all;
}

template <int D, class Number>
HWY_INLINE bool check(const Number* rows, std::size_t count) {
  const auto nothing = [](std::size_t) {};
  return for_rows<D>(rows, count, nothing, nothing);
}

/// Numbers that are ordered as the floats are, and have the same neighbours. Its own inverse.
HWY_INLINE hn::Vec<HalfWords> ordered(hn::Vec<HalfWords> bits) {
  const HalfWords words;
  return hn::Xor(bits, hn::And(hn::BroadcastSignBit(bits), hn::Set(words, INT32_MAX)));
}

/// The nearest floats; what is beyond them is infinite.
HWY_INLINE hn::Vec<Halves> nearest_floats(hn::Vec<Doubles> numbers) {
  const hn::Vec<Halves> near = hn::DemoteTo(Halves(), numbers);
#if HWY_TARGET == HWY_EMU128  // Highway's own ends at the largest float
  float floats[kBytes / sizeof(double)];
  double given[kBytes / sizeof(double)];
  hn::StoreU(near, Halves(), floats);
  hn::StoreU(numbers, Doubles(), given);
  for (std::size_t i = 0; i < kBytes / sizeof(double); ++i)
    if (std::isinf(given[i])) floats[i] = std::copysign(std::numeric_limits<float>::infinity(), floats[i]);
  return hn::LoadU(Halves(), floats);
#else
  return near;
#endif
}

/// The largest floats that are at most these.
HWY_INLINE hn::Vec<Halves> floats_at_most(hn::Vec<Doubles> numbers) {
  const hn::Vec<Halves> near = nearest_floats(numbers);
  const hn::Mask<Doubles> above = hn::Gt(hn::PromoteTo(Doubles(), near), numbers);
  const auto one_less = hn::IfThenElseZero(above, hn::Set(Doubles(), -1.0));
  const auto place = hn::Add(ordered(hn::BitCast(HalfWords(), near)), hn::DemoteTo(HalfWords(), one_less));
  return hn::BitCast(Halves(), ordered(place));
}

/// Rounds numbers that fill vectors; the sign of an upper end is turned, so that it is rounded up.
template <int D, std::size_t Numbers>
HWY_INLINE void round_outward(const double* from, float* to) {
  constexpr std::size_t kLanes = kBytes / sizeof(double);
  static_assert(Numbers % kLanes == 0);
  for (std::size_t k = 0; k < Numbers; k += kLanes) {
    double turned[kLanes];
    float turned_back[kLanes];
    for (std::size_t i = 0; i < kLanes; ++i) {
      const bool is_lower = (k + i) % (2 * D) < D;
      turned[i] = is_lower ? 0.0 : -0.0;
      turned_back[i] = is_lower ? 0.0F : -0.0F;
    }
    const auto sign = hn::LoadU(Doubles(), turned);
    const auto floats = floats_at_most(hn::Xor(hn::LoadU(Doubles(), from + k), sign));
    hn::StoreU(hn::Xor(floats, hn::LoadU(Halves(), turned_back)), Halves(), to + k);
  }
}

template <int D>
HWY_INLINE bool round(const double* rows, std::size_t count, Box<D>* boxes) {
  static_assert(sizeof(Box<D>) == 2 * D * sizeof(float));
  auto* const floats = reinterpret_cast<float*>(boxes);
  const auto together = [=](std::size_t row) {
    round_outward<D, kTogether<double> * 2 * D>(rows + row * 2 * D, floats + row * 2 * D);
  };
  const auto alone = [=](std::size_t row) {
    constexpr std::size_t kPadded = 8;  // a row, and what fills vectors of 2, 4 or 8
    double padded[kPadded] = {};
    float rounded[kPadded];
    std::copy_n(rows + row * 2 * D, 2 * D, padded);
    round_outward<D, kPadded>(padded, rounded);
    std::copy_n(rounded, 2 * D, floats + row * 2 * D);
  };
  return for_rows<D>(rows, count, together, alone);
}

#define KERF_KERNELS(D)                                                                     \
  bool floats_##D(const float* rows, std::size_t count) { return check<D>(rows, count); }   \
  bool doubles_##D(const double* rows, std::size_t count) { return check<D>(rows, count); } \
  bool rounds_##D(const double* rows, std::size_t count, Box<D>* boxes) {                   \
    return round<D>(rows, count, boxes);                                                    \
  }
KERF_KERNELS(2)
KERF_KERNELS(3)
#undef KERF_KERNELS

}  // namespace kerf::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kerf {

#define KERF_EXPORT(D)                                                        \
  HWY_EXPORT(floats_##D);                                                     \
  HWY_EXPORT(doubles_##D);                                                    \
  HWY_EXPORT(rounds_##D);                                                     \
  template <>                                                                 \
  bool are_boxes<D>(const float* rows, std::size_t count) {                   \
    return HWY_DYNAMIC_DISPATCH(floats_##D)(rows, count);                     \
  }                                                                           \
  template <>                                                                 \
  bool are_boxes<D>(const double* rows, std::size_t count) {                  \
    return HWY_DYNAMIC_DISPATCH(doubles_##D)(rows, count);                    \
  }                                                                           \
  template <>                                                                 \
  bool round_boxes<D>(const double* rows, std::size_t count, Box<D>* boxes) { \
    return HWY_DYNAMIC_DISPATCH(rounds_##D)(rows, count, boxes);              \
  }
KERF_EXPORT(2)
KERF_EXPORT(3)
#undef KERF_EXPORT

}  // namespace kerf
#endif
