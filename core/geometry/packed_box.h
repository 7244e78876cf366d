#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "core/geometry/box.h"

namespace kerf {

/// A box as (min, -max), each half of `kHalf` floats, so that one comparison of whole vectors decides overlap
/// or containment. Negation only flips the sign bit, so packing and unpacking return the same floats. Lanes
/// beyond the dimension are 0.
template <int D>
struct alignas(D == 2 ? 16 : 32) PackedBox {
  static constexpr int kHalf = D == 2 ? 2 : 4;
  std::array<Scalar, std::size_t{2} * kHalf> lane{};

  PackedBox() = default;
  explicit constexpr PackedBox(const Box<D>& box) {
    for (int i = 0; i < D; ++i) {
      lane[static_cast<std::size_t>(i)] = box.min[i];
      lane[static_cast<std::size_t>(kHalf + i)] = -box.max[i];
    }
  }
  [[nodiscard]] constexpr Box<D> unpack() const {
    Box<D> box;
    for (int i = 0; i < D; ++i) {
      box.min[i] = lane[static_cast<std::size_t>(i)];
      box.max[i] = -lane[static_cast<std::size_t>(kHalf + i)];
    }
    return box;
  }
};

/// Whether two boxes have the same bits. No branch depends on them.
template <int D>
constexpr bool is_same(const PackedBox<D>& a, const PackedBox<D>& b) {
  using Words = std::array<std::uint64_t, sizeof(PackedBox<D>) / sizeof(std::uint64_t)>;
  const auto words_a = std::bit_cast<Words>(a.lane);
  const auto words_b = std::bit_cast<Words>(b.lane);
  std::uint64_t differ = 0;
  for (std::size_t i = 0; i < words_a.size(); ++i) differ |= words_a[i] ^ words_b[i];
  return differ == 0;
}

/// The box moved by a vector, `by` = PackedBox({vector, vector}); each sum is rounded.
template <int D>
constexpr PackedBox<D> moved(const PackedBox<D>& box, const PackedBox<D>& by) {
  PackedBox<D> result;
  for (std::size_t i = 0; i < box.lane.size(); ++i) result.lane[i] = box.lane[i] + by.lane[i];
  return result;
}

/// The smallest box that holds both: the least of each lane.
template <int D>
constexpr PackedBox<D> join(PackedBox<D> a, const PackedBox<D>& b) {
  for (std::size_t i = 0; i < a.lane.size(); ++i) a.lane[i] = b.lane[i] < a.lane[i] ? b.lane[i] : a.lane[i];
  return a;
}

/// Whether `test(lane)` holds for each lane. Written so that compilers compare whole vectors; no branch
/// depends on a lane.
template <int D, class Test>
constexpr bool holds_in_all_lanes(Test test) {
  std::array<std::uint32_t, std::size_t{2} * PackedBox<D>::kHalf> fails{};
  for (std::size_t i = 0; i < fails.size(); ++i) fails[i] = test(i) ? 0U : ~0U;
  using Words = std::array<std::uint64_t, sizeof(fails) / sizeof(std::uint64_t)>;
  std::uint64_t any = 0;
  for (const std::uint64_t word : std::bit_cast<Words>(fails)) any |= word;
  return any == 0;
}

template <int D>
constexpr bool contains(const PackedBox<D>& outer, const PackedBox<D>& inner) {
  return holds_in_all_lanes<D>([&](std::size_t i) { return outer.lane[i] <= inner.lane[i]; });
}

/// Each lane meets the opposite end of the other box, half a vector away.
template <int D>
constexpr bool overlaps(const PackedBox<D>& a, const PackedBox<D>& b) {
  constexpr std::size_t kHalf = PackedBox<D>::kHalf;
  return holds_in_all_lanes<D>(
      [&](std::size_t i) { return a.lane[i] <= -b.lane[(i + kHalf) % (2 * kHalf)]; });
}

}  // namespace kerf
