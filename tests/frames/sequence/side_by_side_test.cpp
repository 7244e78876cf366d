#include "frames/sequence/side_by_side.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "core/broad_phase/columns.h"
#include "core/broad_phase/loose_octree.h"
#include "core/broad_phase/sweep_and_prune.h"
#include "frames/sequence/farm/panes_parcel.h"
#include "frames/sequence/pane_of.h"
#include "tests/support/dimensions.h"
#include "tests/support/moving_boxes.h"
#include "viz/draw/pane_text.h"

namespace kerf::test {
namespace {

template <int D>
std::vector<std::unique_ptr<BroadPhase<D>>> three() {
  std::vector<std::unique_ptr<BroadPhase<D>>> all;
  all.push_back(std::make_unique<Columns<D>>());
  all.push_back(std::make_unique<SweepAndPrune<D>>());
  all.push_back(std::make_unique<LooseOctree<D>>());
  return all;
}

template <class T>
class SideBySideTest : public testing::Test {};
TYPED_TEST_SUITE(SideBySideTest, Dimensions, DimensionNames);

TYPED_TEST(SideBySideTest, AllGetTheSameBoxes) {
  constexpr int kD = TypeParam::value;
  SideBySide<kD> all(three<kD>());
  MovingBoxes<kD> crowd(all, 30, 1.5, 3);
  crowd.add(200, 5);
  for (std::uint32_t step = 1; step <= 30; ++step) {
    crowd.bounce(1);
    crowd.damage(2);
    crowd.replace(3);
    if (step % 6 == 0) crowd.remove(5);
    all.step();
    const auto sorted = [&](std::size_t k) {
      std::vector<Pair> pairs(all[k].pairs().begin(), all[k].pairs().end());
      std::ranges::sort(pairs);
      return pairs;
    };
    EXPECT_EQ(sorted(0), sorted(1));
    EXPECT_EQ(sorted(0), sorted(2));
    EXPECT_EQ(all.pairs().data(), all[0].pairs().data());
    EXPECT_GT(all.milliseconds(2), 0);
  }
}

TYPED_TEST(SideBySideTest, AnswersRequestsAtOnce) {
  constexpr int kD = TypeParam::value;
  SideBySide<kD> all(three<kD>());
  EXPECT_EQ(all.move({3}, {}), Status::unknown_id);
  EXPECT_EQ(all.insert({3}, {}, Mobility::moving), Status::ok);
  EXPECT_EQ(all.remove({3}), Status::ok);
  EXPECT_EQ(all.remove({3}), Status::unknown_id);
}

TYPED_TEST(SideBySideTest, PanesArriveInAnotherProcessAsTheyWere) {
  constexpr int kD = TypeParam::value;
  SideBySide<kD> all(three<kD>());
  std::vector<Body<kD>> bodies(2);
  bodies[1].box.max[0] = 1;
  for (std::uint32_t k = 0; k < bodies.size(); ++k)
    static_cast<void>(all.insert({k}, bodies[k].box, Mobility::moving));
  all.step();
  PanesFrame<kD> frame;
  frame.scene = "two";
  frame.step = 7;
  frame.step_name = "1250";
  frame.objects = 2;
  frame.moving = 1;
  frame.bodies = bodies;
  frame.contacts = {{{0}, {1}}};
  frame.has_strips = true;
  frame.samples = 1;
  frame.columns = 2;
  for (std::size_t k = 0; k < all.size(); ++k)
    frame.panes.push_back(pane_of<kD>("pane", all[k], frame.bodies, frame.bounds, 1.5));
  const PanesFrame<kD> read = unpack_panes<kD>(pack_panes(frame));
  EXPECT_EQ(read.scene, "two");
  EXPECT_EQ(read.step, 7U);
  EXPECT_EQ(panes_title(read, 100),
            std::vector<std::string>{"scene two  step 1250  objects     2  moving     1"});
  EXPECT_EQ(read.samples, 1);
  EXPECT_EQ(read.columns, 2);
  EXPECT_TRUE(read.has_strips);
  EXPECT_FALSE(read.is_timed);
  EXPECT_EQ(read.contacts, frame.contacts);
  ASSERT_EQ(read.panes.size(), frame.panes.size());
  EXPECT_EQ(pack_panes(read), pack_panes(frame));
  EXPECT_EQ(read.panes[1].parts.lists.size(), frame.panes[1].parts.lists.size());
  EXPECT_EQ(read.panes[2].figures.milliseconds, 1.5);
  EXPECT_EQ(read.panes[2].parts.cells.size(), frame.panes[2].parts.cells.size());
  auto bytes = pack_panes(frame);
  bytes.resize(bytes.size() / 2);
  EXPECT_THROW(static_cast<void>(unpack_panes<kD>(bytes)), std::runtime_error);
}

}  // namespace
}  // namespace kerf::test
