#include "viz/debugger/gui/input_queue.h"

#include <gmock/gmock.h>

#include "tests/support/recorded_crowd.h"
#include "viz/debugger/debugger.h"
#include "viz/debugger/gui/pace.h"

namespace kerf {
namespace {

constexpr double kNow = 5;  // of all that happens within one poll

UserAction action(decltype(UserAction::what) what) { return {kNow, false, false, std::move(what)}; }

std::vector<DebuggerInput> frames_of(InputQueue& queue) {
  std::vector<DebuggerInput> frames;
  while (!queue.is_empty()) frames.push_back(queue.take(kNow));
  return frames;
}

TEST(InputQueue, EachClickOfNoTimeIsSeenDownAndUp) {
  InputQueue queue;
  for (int k = 0; k < 100; ++k) {
    queue.add(action(ButtonChange{0, true}));
    queue.add(action(ButtonChange{0, false}));
  }
  int clicks = 0;
  bool was_down = false;
  for (const DebuggerInput& frame : frames_of(queue))
    clicks += !std::exchange(was_down, frame.buttons[0]) && was_down ? 1 : 0;
  EXPECT_EQ(clicks, 100);
  EXPECT_FALSE(was_down);
}

TEST(InputQueue, AButtonGoesDownAndUpWhereTheMouseWas) {
  InputQueue queue;
  queue.add(action(MouseMove{1, 1}));
  queue.add(action(MouseMove{10, 10}));
  queue.add(action(ButtonChange{1, true}));
  queue.add(action(MouseMove{15, 12}));
  queue.add(action(MouseMove{20, 10}));
  queue.add(action(ButtonChange{1, false}));
  queue.add(action(MouseMove{30, 10}));
  std::vector<std::pair<float, bool>> seen;
  for (const DebuggerInput& frame : frames_of(queue)) seen.emplace_back(frame.mouse_x, frame.buttons[1]);
  // The drag's end is seen while the button is still down: dragging looks only then.
  EXPECT_THAT(seen, testing::ElementsAre(std::pair(10, false), std::pair(10, true), std::pair(20, true),
                                         std::pair(20, false), std::pair(30, false)));
}

TEST(InputQueue, TurnsOfTheWheelAddUpWhereTheyWere) {
  InputQueue queue;
  queue.add(action(MouseMove{1, 1}));
  for (int k = 0; k < 5; ++k) queue.add(action(WheelTurn{1}));
  queue.add(action(WheelTurn{-0.5F}));
  queue.add(action(MouseMove{2, 2}));
  queue.add(action(WheelTurn{2}));
  std::vector<std::pair<float, float>> turns;
  for (const DebuggerInput& frame : frames_of(queue))
    if (frame.wheel != 0) turns.emplace_back(frame.mouse_x, frame.wheel);
  EXPECT_THAT(turns, testing::ElementsAre(std::pair(1, 4.5F), std::pair(2, 2.0F)));
  EXPECT_EQ(queue.take(kNow).wheel, 0);
}

TEST(InputQueue, BetweenTwoTapsAKeyIsUp) {
  InputQueue queue;
  for (int k = 0; k < 3; ++k) queue.add(action(KeyTap{Key::backspace}));
  queue.add(action(KeyTap{Key::enter}));
  std::vector<std::optional<Key>> keys;
  for (const DebuggerInput& frame : frames_of(queue)) keys.push_back(frame.key);
  EXPECT_THAT(keys, testing::ElementsAre(Key::backspace, std::nullopt, Key::backspace, std::nullopt,
                                         Key::backspace, Key::enter));
}

TEST(InputQueue, AHeldKeyDoesNotPileUp) {
  InputQueue queue;
  queue.add(action(KeyTap{Key::right}));
  for (int k = 0; k < 50; ++k) queue.add(action(KeyTap{Key::right, true}));
  EXPECT_EQ(frames_of(queue).size(), 1U);
  queue.add(action(KeyTap{Key::right, true}));
  queue.add(action(KeyTap{Key::right}));
  EXPECT_EQ(std::ranges::count(frames_of(queue), Key::right, &DebuggerInput::key), 2) << "no tap is dropped";
}

TEST(InputQueue, LettersAndKeysKeepTheirOrder) {
  InputQueue queue;
  queue.add(action(TypedText{"a"}));
  queue.add(action(TypedText{"ß"}));
  queue.add(action(KeyTap{Key::backspace}));
  queue.add(action(TypedText{"b"}));
  const auto frames = frames_of(queue);
  ASSERT_EQ(frames.size(), 3U);
  EXPECT_EQ(frames[0].text, "aß");
  EXPECT_EQ(frames[1].key, Key::backspace);
  EXPECT_EQ(frames[1].text + frames[2].text, "b");
}

TEST(InputQueue, WhatIsHeldBelongsToItsClick) {
  InputQueue queue;
  queue.add({kNow, true, false, ButtonChange{0, true}});
  queue.add({kNow, true, false, ButtonChange{0, false}});
  queue.add({kNow, false, true, MouseMove{1, 1}});
  queue.add({kNow, false, false, MouseMove{2, 2}});
  std::vector<std::pair<bool, bool>> held;
  for (const DebuggerInput& frame : frames_of(queue)) held.emplace_back(frame.shift, frame.control);
  EXPECT_THAT(held, testing::ElementsAre(std::pair(true, false), std::pair(true, false),
                                         std::pair(false, true), std::pair(false, false)));
}

TEST(InputQueue, FramesThatAreBehindPassTheTimeOfTheirActions) {
  InputQueue queue;
  (void)queue.take(1);
  queue.add({2, false, false, ButtonChange{0, true}});
  queue.add({2, false, false, ButtonChange{0, false}});
  queue.add({2, false, false, ButtonChange{0, true}});
  queue.add({2.5, false, false, ButtonChange{0, false}});
  EXPECT_DOUBLE_EQ(queue.take(3).seconds, 1);
  EXPECT_LT(queue.take(4).seconds, 0.001);
  EXPECT_LT(queue.take(5).seconds, 0.001) << "a double click stays one, however slow the frames";
  EXPECT_DOUBLE_EQ(queue.take(6).seconds, 4) << "the last one has caught up";
}

TEST(InputQueue, EscapeCanBeTakenOutOfWhatWaits) {
  InputQueue queue;
  queue.add(action(ButtonChange{0, true}));
  queue.add(action(KeyTap{Key::escape}));
  queue.add(action(KeyTap{Key::f}));
  EXPECT_TRUE(queue.take_tap(Key::escape));
  EXPECT_FALSE(queue.take_tap(Key::escape));
  EXPECT_EQ(frames_of(queue).size(), 2U);
}

TEST(Pace, RestsAfterAHintCouldHaveCome) {
  Pace pace;
  double now = 10;
  const auto frames_until = [&](double end) {
    int frames = 0;
    for (; now + pace.seconds_to_next(now) < end; ++frames) {
      now += pace.seconds_to_next(now);
      pace.drawn(now);
    }
    now = end;
    return frames;
  };
  EXPECT_EQ(frames_until(100), Pace::kSettling);
  pace.user_acted(now);
  EXPECT_EQ(frames_until(now + 0.5), Pace::kSettling);
  EXPECT_EQ(frames_until(now + 1000), 1 + Pace::kSettling);
}

/// A debugger without a window that takes in what the queue has.
class QueuedDebugger : public testing::Test {
 protected:
  QueuedDebugger() { test::record_crowd<2>(file_.path(), 120, test::busy_config()); }

  void open() {
    debugger_.emplace(*context_, open_run(file_.path()));
    add(NothingElse{});
    add(NothingElse{});
    take_in();
  }
  void add(decltype(UserAction::what) what) { queue_.add(action(std::move(what))); }
  void move_to(const std::string& name, float share = 0.5F) {
    const auto area = debugger_->gui().find(name);
    ASSERT_TRUE(area) << name;
    add(MouseMove{area->x + share * area->width, area->y + 0.5F * area->height});
  }
  void click() {
    add(ButtonChange{0, true});
    add(ButtonChange{0, false});
  }
  void take_in() {
    while (!queue_.is_empty()) debugger_->take_in(queue_.take(kNow), 1280, 720);
    debugger_->take_in(queue_.take(kNow), 1280, 720);
  }
  [[nodiscard]] std::string fact(const std::string& name) { return debugger_->facts()[name]; }

 private:
  test::TemporaryRecording file_;
  std::unique_ptr<GlContext> context_ = make_offscreen_context();
  std::optional<Debugger> debugger_;
  InputQueue queue_;
};

TEST_F(QueuedDebugger, TakesInAHundredClicksOfOnePoll) {
  open();
  move_to("step forward");
  for (int k = 0; k < 100; ++k) click();
  take_in();
  EXPECT_EQ(fact("step"), "100");
}

TEST_F(QueuedDebugger, AScrubEndsWhereTheButtonWasReleased) {
  open();
  move_to("scrubber", 0.1F);
  add(ButtonChange{0, true});
  move_to("scrubber", 0.75F);
  add(ButtonChange{0, false});
  move_to("scrubber", 0.2F);
  take_in();
  EXPECT_EQ(fact("step"), "90");
}

TEST_F(QueuedDebugger, KeysGoWhereTheyWentWhenTheyWerePressed) {
  open();
  for (int k = 0; k < 100; ++k) add(KeyTap{Key::b});
  take_in();
  EXPECT_EQ(fact("bookmarks"), "0") << "an even number of taps";
  move_to("go to");
  click();
  for (const char* const letter : {"9", "o", "5"}) add(TypedText{letter});
  add(KeyTap{Key::b});  // into the field
  add(KeyTap{Key::left});
  add(KeyTap{Key::backspace});
  add(KeyTap{Key::enter});
  add(KeyTap{Key::b});  // no longer
  take_in();
  EXPECT_EQ(fact("position"), "step 95");
  EXPECT_EQ(fact("bookmarks"), "1");
}

}  // namespace
}  // namespace kerf
