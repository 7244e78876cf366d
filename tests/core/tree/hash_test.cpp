#include "core/tree/hash.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <vector>

#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"
#include "tests/support/planted_tree.h"

namespace kerf::test {
namespace {

template <int D>
kerf::Tree<D> some_tree() {
  Random random(1);
  std::vector<Box<D>> boxes{slab<D>(4, 16)};
  for (int k = 0; k < 30; ++k) boxes.push_back(random_box<D>(random, 20, 1));
  auto tree = tree_of<D>(boxes);
  plant(tree, tree.root(), 0, 10);
  plant(tree, tree[tree.root()].left, 1, 10);
  return tree;
}

template <class T>
class StateHash : public testing::Test {};
TYPED_TEST_SUITE(StateHash, Dimensions, DimensionNames);

TYPED_TEST(StateHash, IsTheSameForCopiesAndForTreesBuiltAlike) {
  constexpr int kD = TypeParam::value;
  const auto tree = some_tree<kD>();
  const auto copy = tree;
  EXPECT_EQ(hash(copy), hash(tree));
  EXPECT_EQ(hash(some_tree<kD>()), hash(tree));
}

TYPED_TEST(StateHash, CopyIsAValueOfItsOwn) {
  constexpr int kD = TypeParam::value;
  const auto tree = some_tree<kD>();
  auto copy = tree;
  plant(copy, copy[copy.root()].right, 1, 5);
  EXPECT_NE(hash(copy), hash(tree));
  EXPECT_EQ(hash(some_tree<kD>()), hash(tree));
}

TYPED_TEST(StateHash, DiffersWhenAnythingDiffers) {
  constexpr int kD = TypeParam::value;
  using Change = std::function<void(kerf::Tree<kD>&)>;
  const auto leaf_of = [](const kerf::Tree<kD>& tree) { return tree[tree.root()].right; };
  const std::vector<std::pair<const char*, Change>> changes{
      {"nothing", [](auto&) {}},
      {"an offset", [](auto& t) { t[t.root()].plane.offset = std::nextafter(10.0F, 11.0F); }},
      {"a direction", [](auto& t) { t[t.root()].direction = 3; }},
      {"a population", [](auto& t) { ++t[t.root()].population; }},
      {"a life", [](auto& t) { ++t[t.root()].generation; }},
      {"a pause", [&](auto& t) { t[leaf_of(t)].retry_step = 20; }},
      {"a refusal", [&](auto& t) { t[leaf_of(t)].refusals = 1; }},
      {"an entry less", [&](auto& t) { t[leaf_of(t)].entries.pop_back(); }},
      {"a mask", [&](auto& t) { t[leaf_of(t)].entries.front().straddle ^= 4U; }},
      {"a key's low end", [&](auto& t) { t[leaf_of(t)].entries.front().key.lo -= 1; }},
      {"a key's high end", [&](auto& t) { t[leaf_of(t)].entries.front().key.hi += 1; }},
      {"another object", [&](auto& t) { t[leaf_of(t)].entries.front().object = ObjectId{99}; }},
      {"the order", [&](auto& t) { std::swap(t[leaf_of(t)].entries[0], t[leaf_of(t)].entries[1]); }},
      {"a box", [](auto& t) { (void)t.table.move({7}, box_at(all<kD>(3), 1)); }},
      {"a quarantine",
       [](auto& t) {
         (void)t.table.move({7}, Box<kD>{all<kD>(1), all<kD>(0)});
       }},
      {"an absence", [](auto& t) { (void)t.table.remove({7}); }},
      {"one object more", [](auto& t) { (void)t.table.insert({31}, slab<kD>(0, 1), Mobility::moving); }},
      {"a fixed object", [](auto& t) { (void)t.table.insert({31}, slab<kD>(0, 1), Mobility::fixed); }},
      {"a plane more", [&](auto& t) { plant(t, leaf_of(t), 0, 15); }},
      {"sides", [](auto& t) { std::swap(t[t.root()].left, t[t.root()].right); }},
  };
  std::set<std::uint64_t> hashes;
  for (const auto& [what, change] : changes) {
    auto tree = some_tree<kD>();
    change(tree);
    EXPECT_TRUE(hashes.insert(hash(tree)).second) << what;
  }
}

}  // namespace
}  // namespace kerf::test
