// Most objects rest, some are too fast for any fat box: those are looked up in each step (DESIGN.md, "Fast").

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "core/broad_phase/bsp.h"
#include "core/broad_phase/bsp_state.h"
#include "core/replay/oracle.h"
#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"
#include "tests/support/pairs.h"

namespace kerf::test {
namespace {

Config small_leaves() {
  Config config = tuned_config();
  config.min_threshold = 64;
  config.max_threshold = 64;
  return config;
}

/// A crowd at rest of which a few jump about, fall asleep and are relieved by others; objects shrink where
/// they are, come and go. All trees of `trees` are told the same.
template <int D>
class Crowd {
 public:
  Crowd(std::uint32_t count, std::vector<kerf::Bsp<D>*> trees) : trees_(std::move(trees)) {
    for (std::uint32_t id = 0; id < count; ++id) {
      boxes_.push_back(somewhere());
      insert(id);
    }
  }
  void advance() {
    for (int k = 0; k < 3; ++k) {
      std::swap(awake_[random_.below(kAwake)], awake_[kAwake - 1]);
      awake_[kAwake - 1] = any();
      shrink(any());
    }
    for (const std::uint32_t id : awake_) {
      const Vector<D> by = random_point<D>(random_, -0.5, 0.5);
      move(id, {boxes_[id].min + by, boxes_[id].max + by});
    }
    replace(awake_.front());
    replace(any());
  }
  /// Everybody jumps, not far.
  void shake(Scalar most) {
    for (std::uint32_t id = 0; id < boxes_.size(); ++id) {
      const Vector<D> by = random_point<D>(random_, -most, most);
      move(id, {boxes_[id].min + by, boxes_[id].max + by});
    }
  }

 private:
  static constexpr std::uint32_t kAwake = 40;

  Box<D> somewhere() {
    const Vector<D> low = random_point<D>(random_, 0, D == 2 ? 24 : 9);
    return {low, low + random_point<D>(random_, 0.5, 1.5)};
  }
  std::uint32_t any() { return random_.below(static_cast<std::uint32_t>(boxes_.size())); }
  static Mobility mobility(std::uint32_t id) { return id % 16 == 0 ? Mobility::fixed : Mobility::moving; }
  void insert(std::uint32_t id) {
    for (kerf::Bsp<D>* tree : trees_) EXPECT_EQ(tree->insert({id}, boxes_[id], mobility(id)), Status::ok);
  }
  void move(std::uint32_t id, const Box<D>& box) {
    boxes_[id] = box;
    for (kerf::Bsp<D>* tree : trees_) EXPECT_EQ(tree->move({id}, box), Status::ok);
  }
  void shrink(std::uint32_t id) {
    const Vector<D> by = (boxes_[id].max - boxes_[id].min) * 0.1F;
    move(id, {boxes_[id].min + by, boxes_[id].max - by});
  }
  void replace(std::uint32_t id) {
    for (kerf::Bsp<D>* tree : trees_) EXPECT_EQ(tree->remove({id}), Status::ok);
    boxes_[id] = somewhere();
    insert(id);
  }

  std::vector<kerf::Bsp<D>*> trees_;
  Random random_{77};
  std::vector<Box<D>> boxes_;
  std::vector<std::uint32_t> awake_ = std::vector<std::uint32_t>(kAwake, 0);
};

template <int D>
std::uint32_t count_restless(const kerf::Bsp<D>& tree) {
  std::uint32_t count = 0;
  for (const Skin& skin : tree.state().skins) count += skin.is_restless() ? 1 : 0;
  return count;
}

template <int D>
bool keeps(const kerf::Bsp<D>& tree) {
  return tree.state().keep_or_sweep.keeps();
}

template <class T>
class Restless : public testing::Test {};
TYPED_TEST_SUITE(Restless, Dimensions, DimensionNames);

TYPED_TEST(Restless, PairsAreTheOraclesWhoeverWakesSleepsShrinksComesOrGoes) {
  constexpr int kD = TypeParam::value;
  kerf::Bsp<kD> tree(small_leaves());
  Crowd<kD> crowd(1200, {&tree});
  std::uint32_t most = 0;
  for (int step = 0; step < 120; ++step) {
    tree.step();
    EXPECT_TRUE(keeps(tree)) << step;
    most = std::max(most, count_restless(tree));
    ASSERT_EQ(difference(tree.pairs(), oracle_pairs(tree.objects())), "") << "step " << step;
    crowd.advance();
  }
  EXPECT_GT(most, 30U);
  EXPECT_LT(most, 150U) << "who sleeps is no longer restless";
}

TYPED_TEST(Restless, ACalmCrowdHasNone) {
  constexpr int kD = TypeParam::value;
  kerf::Bsp<kD> tree(small_leaves());
  Crowd<kD> crowd(600, {&tree});
  for (int step = 0; step < 20; ++step, crowd.advance()) tree.step();
  EXPECT_GT(count_restless(tree), 0U);
  for (int step = 0; step < 2 * Skin::kRestless; ++step) tree.step();
  EXPECT_EQ(count_restless(tree), 0U);
  EXPECT_EQ(difference(tree.pairs(), oracle_pairs(tree.objects())), "");
}

TYPED_TEST(Restless, ThreadsAndStatesGiveTheSameRun) {
  constexpr int kD = TypeParam::value;
  kerf::Bsp<kD> alone(small_leaves());
  kerf::Bsp<kD> shared(small_leaves());
  kerf::Bsp<kD> restored(small_leaves());
  shared.set_threads(3);
  Crowd<kD> crowd(1200, {&alone, &shared, &restored});
  for (int step = 0; step < 90; ++step) {
    alone.step();
    shared.step();
    restored.step();
    ASSERT_TRUE(std::ranges::equal(alone.pairs(), shared.pairs())) << "step " << step;
    ASSERT_EQ(difference(restored.pairs(), alone.pairs()), "") << "step " << step;
    ASSERT_EQ(alone.state_hash(), shared.state_hash()) << "step " << step;
    ASSERT_EQ(alone.state_hash(), restored.state_hash()) << "step " << step;
    if (step % 7 == 3) restored.restore(restored.state());
    crowd.advance();
  }
}

TYPED_TEST(Restless, WhereManyAreTheLeavesAreSwept) {
  constexpr int kD = TypeParam::value;
  kerf::Bsp<kD> tree(small_leaves());
  Crowd<kD> crowd(800, {&tree});
  bool swept = false;
  for (int step = 0; step < 120; ++step) {
    if (step % 40 > 30) {
      crowd.shake(0.5);
    } else {
      crowd.advance();
    }
    tree.step();
    swept |= !keeps(tree);
    ASSERT_EQ(difference(tree.pairs(), oracle_pairs(tree.objects())), "") << "step " << step;
  }
  EXPECT_TRUE(swept);
}

}  // namespace
}  // namespace kerf::test
