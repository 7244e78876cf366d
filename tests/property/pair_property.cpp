#include "tests/property/pair_property.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/tree/placement.h"
#include "tests/property/hard_volumes.h"
#include "tests/support/pairs.h"
#include "tests/support/planted_tree.h"

namespace kerf::test {
namespace {

constexpr std::uint32_t kObjects = 28;
constexpr std::uint32_t kDirections = 12;
/// Trees that share a direction set: one for DOPs takes longer to make than a tree to be tried.
constexpr std::uint64_t kTreesPerSet = 64;

Scalar offset_near(const Interval& shadow, Random& random) {
  constexpr Scalar kLowest = std::numeric_limits<Scalar>::lowest();
  switch (random.below(5)) {
    case 0:
      return shadow.lo;
    case 1:
      return shadow.hi;
    case 2:
      return std::nextafter(shadow.lo, kLowest);
    case 3:
      return std::nextafter(shadow.hi, kLowest);
    default:
      return shadow.lo / 2 + shadow.hi / 2;
  }
}

/// Divides random leaves by planes near the ends of their objects.
template <int D>
void divide_at_random(kerf::Tree<D>& tree, std::uint32_t planes, Random& random) {
  constexpr std::uint32_t kMaxDepth = 12;
  for (std::uint32_t i = 0; i < planes; ++i) {
    NodeId leaf = tree.root();
    while (!tree[leaf].is_leaf()) leaf = random.below(2) == 0 ? tree[leaf].left : tree[leaf].right;
    const std::vector<Entry>& entries = tree[leaf].entries;
    if (entries.empty() || tree[leaf].depth >= kMaxDepth) continue;
    const std::uint32_t direction = random.below(tree.directions().size());
    const ObjectId object = entries[random.below(static_cast<std::uint32_t>(entries.size()))].object;
    const Scalar offset = offset_near(tree.project(direction, object), random);
    if (std::isfinite(offset)) plant(tree, leaf, direction, offset);
  }
}

template <int D>
std::vector<Pair> pairs_by_definition(const ObjectTable<D>& table) {
  std::vector<Pair> pairs;
  for (std::uint32_t a = 0; a < table.bound(); ++a)
    for (std::uint32_t b = a + 1; b < table.bound(); ++b)
      if (table.is_pair({a}, {b})) pairs.push_back({{a}, {b}});
  return pairs;
}

}  // namespace

template <int D>
void PairProperty<D>::try_tree() {
  if (count_.trees % kTreesPerSet == 0) {
    Random random(seed_ ^ ((count_.trees + 1) << 20U));
    projector_ = std::make_shared<const Projector<D>>(
        DirectionSet<D>(hard_directions<D>(kDirections - D, random)), kind_);
  }
  ++count_.trees;
  Random random(Random(seed_ ^ count_.trees).bits());
  kerf::Tree<D> tree(projector_);
  fill(tree, random);
  divide_at_random(tree, 4 + random.below(16), random);
  const std::vector<Pair> expected = pairs_by_definition(tree.table);
  count_.pairs += expected.size();
  compare_intervals(tree, expected);
  compare_pairs(tree, expected);
}

template <int D>
void PairProperty<D>::fill(kerf::Tree<D>& tree, Random& random) const {
  HardVolumes<D> volumes(kind_, random);
  const std::uint32_t clusters = 1 + random.below(3);
  for (std::uint32_t id = 0; id < kObjects; ++id) {
    if (id % (kObjects / clusters) == 0) volumes.begin_cluster();
    (void)tree.table.insert({id}, volumes.next(), Mobility::moving);
    if (tree.table.is_placed({id})) place(tree, tree.root(), {id}, 0);
  }
  sort_phase(tree);
}

template <int D>
void PairProperty<D>::compare_intervals(const kerf::Tree<D>& tree, const std::vector<Pair>& expected) {
  std::vector<Interval> shadow(kObjects);
  for (std::uint32_t direction = 0; direction < tree.directions().size(); ++direction) {
    for (std::uint32_t id = 0; id < kObjects; ++id)
      if (tree.table.is_placed({id})) shadow[id] = tree.project(direction, ObjectId{id});
    for (const Pair& pair : expected) {
      const Interval& a = shadow[pair.a.index()];
      const Interval& b = shadow[pair.b.index()];
      if (!(a.lo <= b.hi && b.lo <= a.hi)) note(count_.apart, "have disjoint intervals", pair);
    }
    count_.intervals += expected.size();
  }
}

template <int D>
void PairProperty<D>::compare_pairs(kerf::Tree<D>& tree, const std::vector<Pair>& expected) {
  const std::vector<Pair> found = sorted(swept(tree));
  auto want = expected.begin();
  for (std::size_t i = 0; i < found.size(); ++i) {
    for (; want != expected.end() && *want < found[i]; ++want) note(count_.missed, "are missed", *want);
    if (i > 0 && found[i - 1] == found[i]) {
      note(count_.twice, "are reported twice", found[i]);
    } else if (want != expected.end() && *want == found[i]) {
      ++want;
    } else {
      note(count_.invented, "are reported and do not overlap", found[i]);
    }
  }
  for (; want != expected.end(); ++want) note(count_.missed, "are missed", *want);
}

template <int D>
void PairProperty<D>::note(std::uint64_t& counter, const char* what, const Pair& pair) {
  ++counter;
  if (!count_.first.empty()) return;
  count_.first = std::to_string(D) + "D " + std::string(to_string(kind_)) + ", seed " +
                 std::to_string(seed_) + ", tree " + std::to_string(count_.trees) + ": objects " +
                 std::to_string(pair.a.value) + " and " + std::to_string(pair.b.value) + " " + what;
}

template class PairProperty<2>;
template class PairProperty<3>;

}  // namespace kerf::test
