// Entries and candidates of a leaf of which pairs are kept: they come, go and are filtered alike by every
// kernel.

#include "core/kernels/kept_leaf.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "core/base/random.h"
#include "core/kernels/byte_sweep.h"
#include "core/kernels/filter_candidates.h"
#include "core/kernels/machine.h"
#include "tests/support/dimensions.h"
#include "tests/support/every_kernel.h"
#include "tests/support/leaf_views.h"
#include "tests/support/pairs.h"

namespace kerf::test {
namespace {

constexpr std::size_t kIds = 100003;

/// The boxes of a view, by object.
template <int D>
std::vector<PackedBox<D>> by_object(const LeafView<D>& view) {
  std::vector<PackedBox<D>> boxes(kIds);
  for (std::size_t i = 0; i < view.size(); ++i) boxes[view.objects[i].index()] = view.boxes[i];
  return boxes;
}

std::vector<Pair> to_vector(const PairBuffer& pairs) { return {pairs.all().begin(), pairs.all().end()}; }

/// A leaf that has the entries of a view and no pairs.
template <int D>
KeptLeaf<D> leaf_of(const LeafView<D>& view, Names names) {
  KeptLeaf<D> leaf;
  empty_leaf(view, leaf);
  append_entries(view, leaf);
  leaf.names = names;
  return leaf;
}

/// Makes candidates of the pairs of the last entries with all before them.
template <int D>
void take_candidates(KeptLeaf<D>& leaf, const LeafView<D>& last, const std::vector<PackedBox<D>>& boxes) {
  Findings found{};
  PairBuffer pairs;
  probe_last<D>(leaf, last, boxes, Names::places, found, pairs);
  for (const Pair& pair : pairs.all()) {
    const ObjectId a{leaf.objects[pair.a.index()]};
    const ObjectId b{leaf.objects[pair.b.index()]};
    const Pair places = a < b ? pair : Pair{pair.b, pair.a};
    leaf.candidates.push_back(leaf.names == Names::places ? places : make_pair(a, b));
  }
}

template <int D>
std::vector<Pair> filtered(const KeptLeaf<D>& leaf, const std::vector<PackedBox<D>>& boxes) {
  PairBuffer pairs;
  std::vector<PackedBox<D>> gathered;
  filter_candidates<D>(leaf, boxes, gathered, pairs);
  return to_vector(pairs);
}

/// The entries of a view whose objects are not among those.
template <int D>
LeafView<D> without(const LeafView<D>& view, const std::set<ObjectId>& gone) {
  LeafView<D> left;
  for (std::size_t i = 0; i < view.size(); ++i) {
    if (gone.contains(view.objects[i])) continue;
    left.boxes.push_back(view.boxes[i]);
    left.objects.push_back(view.objects[i]);
    left.apart.push_back(view.apart[i]);
  }
  return left;
}

template <class T>
class KeptLeaves : public EveryKernel<T> {};
TYPED_TEST_SUITE(KeptLeaves, Dimensions, DimensionNames);

/// The pairs of a leaf of `kept` entries to which others come, go and come again.
template <int D>
std::vector<Pair> pairs_of_coming(const LeafView<D>& leaf, std::size_t kept,
                                  const std::vector<PackedBox<D>>& boxes) {
  KeptLeaf<D> half = leaf_of(part_of(leaf, 0, kept / 2), Names::objects);
  append_entries(part_of(leaf, kept / 2, kept), half);
  const LeafView<D> coming = part_of(leaf, kept, leaf.size());
  append_entries(coming, half);
  drop_last(half, coming.size());
  EXPECT_EQ(half.objects.size(), kept);
  EXPECT_EQ(half.apart.size(), kept);
  append_entries(coming, half);
  ByteSweep<D> sweep;
  PairBuffer pairs;
  sweep.find(part_of(leaf, 0, kept), pairs);
  probe_last<D>(half, coming, boxes, Names::objects, sweep.found, pairs);
  return to_vector(pairs);
}

TYPED_TEST(KeptLeaves, EntriesThatComeFindTheirPartners) {
  constexpr int kD = TypeParam::value;
  constexpr std::size_t kMoreThanOneGo =
      4200;  // probed by 100, these are more rows of 64 than one go confirms
  Random random(5);
  for (const auto& [spread, count, kept] : {std::tuple{Spread::even, 150, 80},
                                            {Spread::grid, 150, 80},
                                            {Spread::huge, 150, 80},
                                            {Spread::outlier, 150, 0},
                                            {Spread::one_point, 150, 75},
                                            {Spread::even, kMoreThanOneGo + 100, kMoreThanOneGo}}) {
    const LeafView<kD> leaf = draw_leaf<kD>(spread, static_cast<std::size_t>(count), random);
    const std::vector<PackedBox<kD>> boxes = by_object(leaf);
    std::vector<Pair> first;
    for (const std::string& name : kernels()) {
      use_kernel(name);
      const std::vector<Pair> pairs = pairs_of_coming<kD>(leaf, static_cast<std::size_t>(kept), boxes);
      EXPECT_EQ(difference(pairs, expected_pairs(leaf)), "") << name;
      if (name == kernels().front()) first = pairs;
      EXPECT_EQ(pairs, first) << name << " gives another order";
    }
  }
}

TYPED_TEST(KeptLeaves, FilterKeepsTouchingBoxesAndDropsSeparatedOnes) {
  constexpr int kD = TypeParam::value;
  LeafView<kD> view;
  view.resize(3);
  for (std::size_t k = 0; k < 3; ++k) {
    const Scalar at = std::array{Scalar{0}, Scalar{1}, std::nextafter(Scalar{1}, Scalar{2})}[k];
    Box<kD> box;
    for (int i = 0; i < kD; ++i) box.max[i] = 1;
    box.min[kD - 1] = at;
    box.max[kD - 1] = at + 1;
    view.boxes[k] = PackedBox<kD>(box);
    view.objects[k] = {static_cast<std::uint32_t>(12 - k)};
  }
  const std::vector<PackedBox<kD>> boxes = by_object(view);
  for (const Names names : {Names::objects, Names::places}) {
    KeptLeaf<kD> leaf = leaf_of(view, names);
    leaf.candidates = names == Names::places ? std::vector<Pair>{{{2}, {0}}, {{2}, {1}}, {{1}, {0}}}
                                             : std::vector<Pair>{{{10}, {12}}, {{10}, {11}}, {{11}, {12}}};
    for (const std::string& name : kernels()) {
      use_kernel(name);
      EXPECT_EQ(filtered(leaf, boxes), (std::vector<Pair>{{{10}, {11}}, {{11}, {12}}})) << name;
    }
  }
}

/// Far away boxes are rounded, so that many touch: what comes then finds them by their bytes.
TYPED_TEST(KeptLeaves, WhatComesAfterAShiftFindsItsPartners) {
  constexpr int kD = TypeParam::value;
  Random random(7);
  for (const auto& [way, ranked] : {std::pair{0.3F, false}, {1e6F, false}, {-2e7F, false}, {1e6F, true}}) {
    LeafView<kD> all = draw_leaf<kD>(Spread::even, 300, random);
    Vector<kD> vector;
    for (int axis = 0; axis < kD; ++axis) vector[axis] = way;
    const PackedBox<kD> by({vector, vector});
    for (const std::string& name : kernels()) {
      use_kernel(name);
      KeptLeaf<kD> leaf = leaf_of(part_of(all, 0, 200), Names::objects);
      if (ranked) rank_bytes(all, leaf);
      LeafView<kD> there = all;
      for (PackedBox<kD>& box : there.boxes) box = moved(box, by);
      const std::vector<PackedBox<kD>> boxes = by_object(there);
      move_bytes(vector, leaf);
      std::vector<PackedBox<kD>> gathered;
      renew_bytes<kD>(leaf, boxes, gathered);
      append_entries(part_of(there, 200, 300), leaf);
      take_candidates(leaf, part_of(there, 200, 300), boxes);
      std::vector<Pair> found = filtered(leaf, boxes);
      const std::vector<Pair> first = expected_pairs(part_of(there, 0, 200));
      found.insert(found.end(), first.begin(), first.end());
      EXPECT_EQ(difference(found, expected_pairs(there)), "") << name << ", " << way;
    }
  }
}

/// One by one and many at once, while others come.
TYPED_TEST(KeptLeaves, WhatGoesTakesItsPairsAlong) {
  constexpr int kD = TypeParam::value;
  Random random(6);
  const LeafView<kD> all = draw_leaf<kD>(Spread::even, 300, random);
  const std::vector<PackedBox<kD>> boxes = by_object(all);
  for (const Names names : {Names::objects, Names::places}) {
    for (const std::string& name : kernels()) {
      SCOPED_TRACE(testing::Message() << name << ", names " << static_cast<int>(names));
      use_kernel(name);
      KeptLeaf<kD> leaf = leaf_of(part_of(all, 0, 200), names);
      take_candidates(leaf, part_of(all, 0, 200), boxes);
      leaf.resting.pairs = leaf.near = expected_pairs(part_of(all, 0, 200));
      std::set<ObjectId> gone;
      std::vector<std::uint32_t> going;
      for (std::size_t k = 0; k < 40; ++k) {
        const ObjectId object = all.objects[(k * 37 + 199) % 200];  // the last one, too
        gone.insert(object);
        going.push_back(object.value);
      }
      going[13] = all.objects[250].value;  // it has no entry
      gone.erase(all.objects[(13 * 37 + 199) % 200]);
      std::size_t done = 0;
      for (const std::size_t count : {1U, 2U, 3U, 4U, 5U, 8U, 0U, 17U}) {
        drop_objects<kD>(leaf, std::span(going).subspan(done, count));
        done += count;
      }
      ASSERT_EQ(done, going.size());
      const std::vector<Pair> left = expected_pairs(without(part_of(all, 0, 200), gone));
      ASSERT_EQ(difference(filtered(leaf, boxes), left), "");
      ASSERT_EQ(difference(leaf.resting.pairs, left), "");
      ASSERT_EQ(difference(leaf.near, left), "");
      append_entries(part_of(all, 200, 300), leaf);
      take_candidates(leaf, part_of(all, 200, 300), boxes);
      ASSERT_EQ(difference(filtered(leaf, boxes), expected_pairs(without(all, gone))), "");
      std::vector<std::uint8_t> marks(kIds, 0);
      for (std::size_t k = 0; k < 300; k += 3) {
        marks[all.objects[k].index()] = 1;
        gone.insert(all.objects[k]);
      }
      drop_marked<kD>(leaf, marks);
      ASSERT_EQ(leaf.objects.size(), without(all, gone).size());
      ASSERT_EQ(difference(filtered(leaf, boxes), expected_pairs(without(all, gone))), "");
      ASSERT_EQ(difference(leaf.resting.pairs, expected_pairs(without(part_of(all, 0, 200), gone))), "");
    }
  }
}

}  // namespace
}  // namespace kerf::test
