// Each policy beyond the paper has a switch. Without it the pairs are the same, found in another way.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "core/bsp/bsp.h"
#include "core/bsp/bsp_state.h"
#include "tests/support/boxes.h"
#include "tests/support/checked.h"
#include "tests/support/dimensions.h"
#include "tests/support/moving_boxes.h"
#include "tests/support/pairs.h"
#include "tests/support/sound.h"

namespace kerf::test {
namespace {

constexpr std::array kSwitchedOff{
    "byte_sweep=0",  "skin=0",     "stream_share=1",
    "bulk_factor=0", "restless=0", "resting_pairs=0",
    "leaf_boxes=0",  "dense=0",    "restless=0,resting_pairs=0,leaf_boxes=0,dense=0"};

/// The tuned configuration with leaves of so many objects, without a policy.
Config tuned_without(std::string_view policy, std::uint32_t threshold = 16) {
  Config config = tuned_config();
  config.min_threshold = config.max_threshold = threshold;
  kerf::apply(config, policy);
  return config;
}

template <int D>
double side_for(std::uint32_t count) {
  return 2.5 * std::pow(count, 1.0 / D);
}

template <class T>
class Policies : public testing::Test {
 protected:
  /// The motions of a policy's scenes: rest, slow walks, flights, jumps and exchanges.
  static void move(MovingBoxes<T::value>& crowd, std::uint32_t step) {
    const std::uint32_t phase = step / 25 % 4;
    if (phase == 1) crowd.walk(0.03);
    if (phase == 2) crowd.bounce(1);
    if (phase == 3 && step % 5 == 0) crowd.teleport();
    if (step % 9 == 0) crowd.replace(4);
  }
  /// Whether two trees that differ in one policy have the same pairs in every step, and whether these ever
  /// come in another order. `move(crowd, step)` is called for each of both.
  template <class MotionOfStep>
  static bool is_order_the_same(const Config& with, const Config& without, double side, MotionOfStep motion) {
    Bsp<T::value> one(with);
    Bsp<T::value> other(without);
    MovingBoxes<T::value> crowd_of_one(one, side, 0.7, 3);
    MovingBoxes<T::value> crowd_of_other(other, side, 0.7, 3);
    crowd_of_one.add(400, 6);
    crowd_of_other.add(400, 6);
    bool same = true;
    for (std::uint32_t step = 0; step < 30; ++step) {
      motion(crowd_of_one, step);
      motion(crowd_of_other, step);
      one.step();
      other.step();
      EXPECT_EQ(difference(one.pairs(), other.pairs()), "") << "in step " << step;
      same &= std::ranges::equal(one.pairs(), other.pairs());
    }
    return same;
  }
};
TYPED_TEST_SUITE(Policies, Dimensions, DimensionNames);

TYPED_TEST(Policies, WithoutAnyOfThemPairsAreTheOracles) {
  constexpr int kD = TypeParam::value;
  for (const char* const policy : kSwitchedOff) {
    SCOPED_TRACE(policy);
    Bsp<kD> tree(tuned_without(policy));
    Checked<kD> checked(tree);
    MovingBoxes<kD> crowd(checked, side_for<kD>(250), 1.2, 8);
    crowd.add(250, 5);
    for (std::uint32_t step = 0; step < 110; ++step) {
      this->move(crowd, step);
      checked.step();
      ASSERT_FALSE(this->HasFailure()) << "in step " << step;
    }
    EXPECT_TRUE(is_sound(tree.tree()));
  }
}

TYPED_TEST(Policies, MayBeSwitchedInTheMidstOfARun) {
  constexpr int kD = TypeParam::value;
  Bsp<kD> tree(tuned_without(""));
  Checked<kD> checked(tree);
  MovingBoxes<kD> crowd(checked, side_for<kD>(250), 1.2, 9);
  crowd.add(250, 5);
  for (std::uint32_t step = 0; step < 220; ++step) {
    if (step % 6 == 0) tree.set_config(tuned_without(kSwitchedOff[step / 6 % kSwitchedOff.size()]));
    if (step % 6 == 3) tree.set_config(tuned_without(""));
    this->move(crowd, step);
    checked.step();
    ASSERT_FALSE(this->HasFailure()) << "in step " << step;
  }
}

TYPED_TEST(Policies, WithoutRestlessObjectsFastOnesArePlacedAnewInEachStep) {
  constexpr int kD = TypeParam::value;
  for (const bool restless : {true, false}) {
    Config config = tuned_without(restless ? "" : "restless=0", 64);
    Bsp<kD> tree(config);
    std::vector<Box<kD>> boxes;
    Random random(4);
    for (std::uint32_t id = 0; id < 1000; ++id) {
      const Vector<kD> low = random_point<kD>(random, 0, side_for<kD>(1000));
      boxes.push_back({low, low + random_point<kD>(random, 1, 1)});
      ASSERT_EQ(tree.insert({id}, boxes.back(), Mobility::moving), Status::ok);
    }
    for (int step = 0; step < 10; ++step) {
      tree.step();
      for (std::uint32_t id = 0; id < 10; ++id) {
        const Vector<kD> by = random_point<kD>(random, -0.5, 0.5);
        ASSERT_EQ(tree.move({id}, {boxes[id].min + by, boxes[id].max + by}), Status::ok);
      }
    }
    tree.step();
    ASSERT_EQ(tree.mode(), Mode::kept);
    const auto skins = tree.state().skins;
    EXPECT_EQ(std::ranges::count_if(skins, [](const Skin& skin) { return skin.is_restless(); }),
              restless ? 10 : 0);
  }
}

/// The pairs of objects at rest come first, those of all leaves before all others.
TYPED_TEST(Policies, WithoutRestingPairsAllComeLeafByLeaf) {
  const auto few_move = [](auto& crowd, std::uint32_t step) {
    if (step % 10 == 5) crowd.replace(20);
  };
  const double side = side_for<TypeParam::value>(300);
  EXPECT_FALSE(this->is_order_the_same(tuned_without(""), tuned_without("resting_pairs=0"), side, few_move));
}

/// The pairs that floats confirm come behind those of which bytes alone are sure.
TYPED_TEST(Policies, WithoutDenseLeavesPairsComeInTheOrderOfTheBytes) {
  const auto all_move = [](auto& crowd, std::uint32_t) { crowd.bounce(1); };
  const Config with = tuned_without("skin=0", 1024);
  const Config without = tuned_without("skin=0,dense=0", 1024);
  EXPECT_FALSE(this->is_order_the_same(with, without, 2.5, all_move));
  EXPECT_TRUE(this->is_order_the_same(with, without, 200, all_move)) << "no leaf is dense";
}

/// One object with so high an id that the table of boxes is long.
TYPED_TEST(Policies, WithoutLeafBoxesNoneAreCopied) {
  constexpr int kD = TypeParam::value;
  constexpr std::uint32_t kFar = tuning::kOwnPages / sizeof(PackedBox<kD>);
  for (const bool leaf_boxes : {true, false}) {
    const Config config = tuned_without(leaf_boxes ? "skin=0" : "skin=0,leaf_boxes=0");
    Tree<kD> tree(make_projector<kD>(config, VolumeKind::box));
    Requests<kD> requests(VolumeKind::box);
    StepMemory<kD> memory;
    const ThreadUse threads{};
    Reporter<NoTrace> reporter;
    SweptStep<kD> swept;
    const StepContext<kD> step{config, tree, requests, memory, threads, 1};
    ASSERT_EQ(requests.insert({kFar}, slab<kD>(0, 1), Mobility::moving, {tree.table, threads.pool(), false}),
              Status::ok);
    swept.place_all(step, Mode::swept, Mode::swept, reporter);
    EXPECT_EQ(swept.copies_boxes(), leaf_boxes);
    swept.place_all(step, Mode::kept, Mode::ordered, reporter);
    EXPECT_FALSE(swept.copies_boxes()) << "ordered lists need none";
  }
}

}  // namespace
}  // namespace kerf::test
