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

template <int D>
constexpr bool contains(const PackedBox<D>& outer, const PackedBox<D>& inner) {
  bool all = true;
  for (std::size_t i = 0; i < outer.lane.size(); ++i) all &= outer.lane[i] <= inner.lane[i];
  return all;
}

template <int D>
constexpr bool overlaps(const PackedBox<D>& a, const PackedBox<D>& b) {
  constexpr std::size_t kHalf = PackedBox<D>::kHalf;
  bool all = true;
  for (std::size_t i = 0; i < a.lane.size(); ++i) all &= a.lane[i] <= -b.lane[(i + kHalf) % a.lane.size()];
  return all;
}

}  // namespace kerf
