#include "viz/debugger/model/view_history.h"

#include <gmock/gmock.h>

namespace kerf {
namespace {

class History : public testing::Test {
 protected:
  History() { see(); }
  void see(ViewFrame frame = {}) {
    frame.seconds = 1.0 / 60;
    history.see(now, frame);
  }
  void turn_camera() { camera().yaw += 1; }
  CameraChoice<3>& camera() { return std::get<CameraChoice<3>>(now.camera); }
  void pause() {
    for (int k = 0; k < 60; ++k) see();
  }

  ViewState now{{}, CameraChoice<3>{}, TimeWindow(100), {}};
  ViewHistory history;
};

TEST_F(History, AChangeIsTakenBackAndMadeAgain) {
  const ViewState first = now;
  now.settings.tint = Tint::cost;
  see();
  now.selection = NodeId{3};
  see();
  const ViewState last = now;
  ASSERT_EQ(history.changes(), 2U);
  EXPECT_EQ(history.undo()->selection, Selection());
  EXPECT_EQ(*(history.undo()), first);
  EXPECT_FALSE(history.undo());
  EXPECT_EQ(history.redo()->settings.tint, Tint::cost);
  EXPECT_EQ(*(history.redo()), last);
  EXPECT_FALSE(history.redo());
}

TEST_F(History, TakingBackIsNoChange) {
  now.settings.tint = Tint::cost;
  see();
  now = *history.undo();
  see();
  EXPECT_EQ(history.changes(), 0U);
  EXPECT_EQ(history.taken_back(), 1U);
}

TEST_F(History, ANewChangeEndsWhatCanBeMadeAgain) {
  now.settings.tint = Tint::cost;
  see();
  now = *history.undo();
  now.settings.tint = Tint::age;
  see();
  EXPECT_EQ(history.taken_back(), 0U);
  EXPECT_EQ(history.changes(), 1U);
}

TEST_F(History, ADragIsOneChange) {
  const ViewState first = now;
  for (int drag = 1; drag <= 2; ++drag) {
    see({.held = true});
    for (int k = 0; k < 8; ++k) {
      turn_camera();
      see({.held = true});
    }
    see();
    EXPECT_EQ(history.changes(), static_cast<std::size_t>(drag));
  }
  (void)history.undo();
  EXPECT_EQ(*history.undo(), first);
}

TEST_F(History, TurnsOfTheWheelThatFollowEachOtherAreOneChange) {
  for (int k = 0; k < 5; ++k) {
    turn_camera();
    see();
    see();
  }
  EXPECT_EQ(history.changes(), 1U);
  now.window.zoom(2, 50, 1);
  see();
  EXPECT_EQ(history.changes(), 2U) << "of the lanes";
  pause();
  now.window.zoom(2, 50, 1);
  see();
  EXPECT_EQ(history.changes(), 3U) << "after a pause";
}

TEST_F(History, TwoKeysOfOneInstantAreTwoChanges) {
  for (const Tint tint : {Tint::cost, Tint::age}) {
    now.settings.tint = tint;
    see();
  }
  EXPECT_EQ(history.changes(), 2U);
}

TEST_F(History, LanesThatFollowTheRunAreNoChange) {
  now.window.show(20, 40);
  see();
  const TimeWindow shown = now.window;
  now.window.show(40, 60);
  see({.moved = true});
  EXPECT_EQ(history.changes(), 1U);
  now.settings.tint = Tint::age;
  see();
  EXPECT_NE(history.undo()->window, shown);
}

TEST_F(History, ForgetsTheEarliest) {
  for (std::uint32_t k = 0; k < ViewHistory::kMost + 5; ++k) {
    now.selection = NodeId{k};
    see();
  }
  EXPECT_EQ(history.changes(), ViewHistory::kMost);
}

}  // namespace
}  // namespace kerf
