#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/kernels/leaf_view.h"
#include "core/random.h"

namespace kerf::test {

/// Where the boxes of a leaf may lie: each draws its ends in its own way.
enum class Spread { even, grid, tiny, huge, outlier, one_point };

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
  }
  return x;
}

template <int D>
Box<D> draw_box(Spread spread, Random& random) {
  Box<D> box;
  for (int i = 0; i < D; ++i) {
    const Scalar a = draw(spread, random);
    const Scalar b =
        spread == Spread::even ? a + static_cast<Scalar>(random.uniform(0, 2)) : draw(spread, random);
    box.min[i] = std::min(a, b);
    box.max[i] = std::max(a, b);
  }
  return box;
}

/// A leaf of `count` boxes with ids in no order; some entries lie apart, some are fixed.
template <int D>
LeafView<D> draw_leaf(Spread spread, std::size_t count, Random& random) {
  LeafView<D> leaf;
  leaf.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    leaf.boxes[i] = PackedBox<D>(draw_box<D>(spread, random));
    leaf.objects[i] = {static_cast<std::uint32_t>((i * 7919 + 13) % 100003)};
    leaf.apart[i] = random.bits() & random.bits() & 7U;
    if (random.uniform(0, 1) < 0.1) leaf.apart[i] |= LeafView<D>::kFixedBit;
  }
  return leaf;
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
