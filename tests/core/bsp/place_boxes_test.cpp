#include "core/bsp/place_boxes.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "core/bsp/bsp.h"
#include "core/tree/validate.h"
#include "tests/support/checked.h"
#include "tests/support/config_of.h"
#include "tests/support/dimensions.h"
#include "tests/support/moving_boxes.h"

namespace kerf::test {
namespace {

/// What a step may take for moves alone: with them it asks for no one who came or went.
TEST(RequestsOfMoves, AreMovesHoweverOftenAnObjectMoves) {
  ObjectTable<2> table;
  TaskPool pool(1);
  const Requests<2>::Receiver tree{table, pool, false};
  Requests<2> requests(VolumeKind::box);
  const auto move = [&](Scalar to) {
    const ObjectId object{0};
    const Box<2> box{{{to, 0}}, {{to + 1, 1}}};
    return requests.move_many({&object, 1}, {&box, 1}, tree);
  };
  ASSERT_EQ(requests.insert({0}, Box<2>{{{0, 0}}, {{1, 1}}}, Mobility::moving, tree), Status::ok);
  EXPECT_FALSE(requests.are_moves());
  requests.finish_step({}, pool);
  EXPECT_EQ(move(1), Status::ok);
  EXPECT_EQ(move(2), Status::ok);
  EXPECT_TRUE(requests.are_moves());
  EXPECT_EQ(requests.changed().size(), 1U);
  EXPECT_NE(move(std::numeric_limits<Scalar>::quiet_NaN()), Status::ok);
  EXPECT_FALSE(requests.are_moves());
}

template <class T>
class PlacedWithTraffic : public testing::Test {};
TYPED_TEST_SUITE(PlacedWithTraffic, Dimensions, DimensionNames);

/// Nearly all objects move a little, so that they stay in their leaves, and a few come, go, come back
/// elsewhere, lose their box or get it back: few enough to be treated one by one.
TYPED_TEST(PlacedWithTraffic, LeavesHaveWhatIsThere) {
  constexpr int kD = TypeParam::value;
  for (const char* skin : {"skin=0", "skin=8"}) {
    for (const unsigned threads : {1U, 3U}) {
      Bsp<kD> tree(
          config_of(std::string("byte_sweep=1,stream_share=0.06,max_redundancy=0.4,schedule_interval=1,"
                                "budget_divisor=1,min_threshold=16,max_threshold=32,free_directions=0,") +
                    skin));
      tree.set_threads(threads, Sharing::always);
      Checked<kD> checked(tree);
      MovingBoxes<kD> crowd(checked, kD == 2 ? 30 : 12, 1, 5);
      crowd.add(400, 9);
      for (int step = 0; step < 80; ++step) {
        crowd.walk(step % 20 < 15 ? 0.2 : 0.9);
        if (step % 2 == 0) crowd.remove(4);
        if (step % 2 == 1) crowd.add(4, 3);
        if (step % 3 == 0) crowd.replace(2);
        if (step % 5 == 0) crowd.damage(2);
        if (step % 5 == 3) crowd.heal();
        checked.step();
        EXPECT_TRUE(validate(tree.tree()).empty()) << "step " << step;
      }
    }
  }
}

/// The last objects go, and the first come, in steps in which all others move.
TYPED_TEST(PlacedWithTraffic, AWorldMayEmptyAndFill) {
  constexpr int kD = TypeParam::value;
  Bsp<kD> tree(tuned_config());
  Checked<kD> checked(tree);
  MovingBoxes<kD> crowd(checked, 6, 1, 8);
  for (int round = 0; round < 2; ++round) {
    for (int step = 0; step < 40; ++step) {
      crowd.add(1);
      crowd.walk(0.3);
      checked.step();
    }
    for (int step = 0; step < 40; ++step) {
      crowd.remove(1);
      crowd.walk(0.3);
      checked.step();
    }
    EXPECT_EQ(tree.tree().entries(), 0U);
  }
}

}  // namespace
}  // namespace kerf::test
