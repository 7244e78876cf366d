#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "core/base/random.h"
#include "core/kernels/leaf_view.h"

namespace kerf::test {

/// Where the boxes of a leaf may lie: each draws its ends in its own way.
enum class Spread {
  even,
  grid,
  tiny,
  huge,
  outlier,
  one_point,
  flat,      ///< all share a point of the last axis
  touching,  ///< all that share is a point: some begin where others end
  dense,     ///< each overlaps many
};

inline Scalar draw(Spread spread, Random& random) {
  const auto x = static_cast<Scalar>(random.uniform(-1, 1));
  switch (spread) {
    case Spread::even:
      return 10 * x;
    case Spread::grid:
      return std::round(4 * x);
    case Spread::tiny:
      return x * std::numeric_limits<Scalar>::denorm_min() * 50;
    case Spread::huge:
      return x * std::numeric_limits<Scalar>::max();
    case Spread::outlier:
      return random.uniform(0, 1) < 0.02 ? x * 1e30F : x;
    case Spread::one_point:
      return 7;
    case Spread::flat:
    case Spread::touching:
    case Spread::dense:
      return 10 * x;
  }
  return x;
}

/// How far a box reaches along an axis, where its ends are not drawn one by one.
inline std::optional<double> most_extent(Spread spread) {
  switch (spread) {
    case Spread::even:
    case Spread::flat:
    case Spread::touching:
      return 2;
    case Spread::dense:
      return 10;
    default:
      return std::nullopt;
  }
}

template <int D>
Box<D> draw_box(Spread spread, Random& random) {
  const std::optional<double> most = most_extent(spread);
  Box<D> box;
  for (int i = 0; i < D; ++i) {
    const Scalar a = draw(spread, random);
    const Scalar b = most ? a + static_cast<Scalar>(random.uniform(0, *most)) : draw(spread, random);
    box.min[i] = std::min(a, b);
    box.max[i] = std::max(a, b);
  }
  const auto share = static_cast<Scalar>(random.uniform(0, 2));
  if (spread == Spread::flat) {
    box.min[D - 1] = -share;
    box.max[D - 1] = 1;
  }
  if (spread == Spread::touching) {
    box.min[D - 1] = share < 1 ? 3 : 2;
    box.max[D - 1] = share < 1 ? 4 : 3;
  }
  return box;
}

/// A leaf of `count` boxes with ids in no order; some entries lie apart, by some of three planes, and some
/// are fixed.
template <int D>
LeafView<D> draw_leaf(Spread spread, std::size_t count, Random& random, DepthMask planes = 7U) {
  LeafView<D> leaf;
  leaf.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    leaf.boxes[i] = PackedBox<D>(draw_box<D>(spread, random));
    leaf.objects[i] = {static_cast<std::uint32_t>((i * 7919 + 13) % 100003)};
    leaf.apart[i] = random.bits() & random.bits() & planes;
    if (random.uniform(0, 1) < 0.1) leaf.apart[i] |= LeafView<D>::kFixedBit;
  }
  return leaf;
}

/// One more entry, which nothing keeps apart from others. Its id is its place.
template <int D>
void add_entry(LeafView<D>& leaf, const Box<D>& box) {
  leaf.boxes.emplace_back(box);
  leaf.objects.push_back({static_cast<std::uint32_t>(leaf.objects.size())});
  leaf.apart.push_back(0);
}

template <int D>
std::vector<Pair> expected_pairs(const LeafView<D>& leaf) {
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < leaf.size(); ++i)
    for (std::size_t j = i + 1; j < leaf.size(); ++j)
      if ((leaf.apart[i] & leaf.apart[j]) == 0 && overlaps(leaf.boxes[i].unpack(), leaf.boxes[j].unpack()))
        pairs.push_back(make_pair(leaf.objects[i], leaf.objects[j]));
  return pairs;
}

template <int D>
LeafView<D> part_of(const LeafView<D>& leaf, std::size_t begin, std::size_t end) {
  LeafView<D> part;
  part.boxes.assign(leaf.boxes.data() + begin, leaf.boxes.data() + end);
  part.objects.assign(leaf.objects.data() + begin, leaf.objects.data() + end);
  part.apart.assign(leaf.apart.data() + begin, leaf.apart.data() + end);
  return part;
}

}  // namespace kerf::test
