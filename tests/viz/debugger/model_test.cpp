#include <gmock/gmock.h>

#include <fstream>

#include "core/trace/event_facts.h"
#include "tests/support/dimensions.h"
#include "tests/support/recorded_crowd.h"
#include "tests/support/temporary_folder.h"
#include "viz/debugger/model/algorithm_1.h"
#include "viz/debugger/model/debugger_model.h"

namespace kerf {
namespace {

using ::testing::HasSubstr;

/// A crowd in which operators act, and a model of it.
template <class T>
class DebuggerModelTest : public testing::Test {
 protected:
  static constexpr int kD = T::value;
  static constexpr std::uint32_t kSteps = 60;

  DebuggerModelTest() {
    test::record_crowd<kD>(file_.path(), kSteps, test::busy_config());
    model_ = std::make_unique<DebuggerModel>(open_run(file_.path()));
    model_->work_folder = folder_.path();
  }
  [[nodiscard]] DebuggerModel& model() { return *model_; }

  /// The first event after which `text` holds.
  Position first(const std::string& text) {
    return model_->run().search(Expression::parse(text), {}, true, {}).value_or(Position{});
  }

 private:
  test::TemporaryRecording file_;
  test::TemporaryFolder folder_;
  std::unique_ptr<DebuggerModel> model_;
};
TYPED_TEST_SUITE(DebuggerModelTest, test::Dimensions, test::DimensionNames);

TYPED_TEST(DebuggerModelTest, TheSameStateForwardsAndBackwards) {
  DebuggerModel& model = this->model();
  model.go(Position::end_of(8));
  std::vector<std::pair<Position, std::uint64_t>> seen;
  for (int k = 0; k < 150; ++k) {
    seen.emplace_back(model.run().position(), model.run().state_hash());
    model.step(Granularity::event, true);
  }
  while (!seen.empty()) {
    model.step(Granularity::event, false);
    ASSERT_EQ(model.run().position(), seen.back().first);
    ASSERT_EQ(model.run().state_hash(), seen.back().second);
    seen.pop_back();
  }
}

TYPED_TEST(DebuggerModelTest, EveryKindOfBreakpointStopsBothWays) {
  DebuggerModel& model = this->model();
  model.go(this->first("op==split && kind==acted"));
  const std::string node = "n" + std::to_string(model.run().event_node()->value);
  model.go(Position::end_of(this->kSteps));
  const Pair pair = model.run().pairs()[0];
  const std::string names = std::to_string(pair.a.value) + "," + std::to_string(pair.b.value);
  for (const std::string& text :
       {std::string("op==swap"), std::string("kind==refused"), std::string("depth>2"),
        std::string("phase==operate"), "plane(" + node + ") moves", "node(" + node + ")",
        "object(" + std::to_string(pair.a.value) + ") moves", "pair(" + names + ")",
        "pair(" + names + ") enters", std::string("redundancy>1%"), std::string("deferred>0"),
        std::string("step_time>1.01*median"), std::string("height>=3 && pairs>0")}) {
    SCOPED_TRACE(text);
    model.breakpoints.clear();
    model.add_breakpoint(text);
    model.go({});
    model.run_to_breakpoint(true);
    const Position there = model.run().position();
    ASSERT_EQ(model.breakpoints[0].hits, 1U) << model.message;
    EXPECT_TRUE(model.run().value(Expression::parse(text)).is_true());
    EXPECT_THAT(model.message, HasSubstr(to_string(there, GivenNames{})));
    model.go(Position::end_of(this->kSteps));
    model.step(Granularity::event, true);
    model.run_to_breakpoint(false);
    EXPECT_GE(model.run().position(), there);
    EXPECT_TRUE(model.run().value(Expression::parse(text)).is_true());
  }
}

TYPED_TEST(DebuggerModelTest, TheNearestOfSeveralBreakpointsStops) {
  DebuggerModel& model = this->model();
  model.add_breakpoint("step==30");
  model.add_breakpoint("step==20");
  model.add_breakpoint("step==10");
  model.breakpoints[2].enabled = false;
  model.run_to_breakpoint(true);
  EXPECT_EQ(model.run().position(), Position::end_of(20));
  model.go(Position::end_of(40));
  model.run_to_breakpoint(false);
  EXPECT_EQ(model.run().position(), Position::end_of(30));
  EXPECT_THROW(model.add_breakpoint("redundncy>1"), std::invalid_argument);
  EXPECT_EQ(model.breakpoints.size(), 3U);
}

TYPED_TEST(DebuggerModelTest, LongWorkIsShownAndCanBeEnded) {
  DebuggerModel& model = this->model();
  std::uint32_t calls = 0;
  model.on_long_work = [&](std::uint32_t /*step*/) { return ++calls < 10; };
  model.add_breakpoint("height>99");
  model.run_to_breakpoint(true);
  EXPECT_EQ(calls, 10U);
  EXPECT_EQ(model.run().position(), Position());
  EXPECT_THAT(model.message, HasSubstr("ended before"));
  model.on_long_work = {};
  model.run_to_breakpoint(true);
  EXPECT_THAT(model.message, HasSubstr("no breakpoint holds"));
}

TYPED_TEST(DebuggerModelTest, ABreakpointHereIsRemovedByTheSameKey) {
  DebuggerModel& model = this->model();
  model.go(this->first("op==split && kind==acted"));
  const Position here = model.run().position();
  model.toggle_breakpoint_here();
  ASSERT_EQ(model.breakpoints.size(), 1U);
  model.go(Position::end_of(this->kSteps));
  model.run_to_breakpoint(false);
  EXPECT_EQ(model.run().position(), here);
  model.toggle_breakpoint_here();
  EXPECT_TRUE(model.breakpoints.empty());
}

TYPED_TEST(DebuggerModelTest, WatchesFollowTheMoment) {
  DebuggerModel& model = this->model();
  model.add_watch("pairs");
  for (const std::uint32_t step : {10U, 50U, 10U}) {
    model.go(Position::end_of(step));
    EXPECT_EQ(model.watches()[0].value, ConditionNumber::of(model.run().rows()[step - 1].pairs));
  }
}

TYPED_TEST(DebuggerModelTest, AWatchStopsTheRunWhereItsValueChangesBothWays) {
  DebuggerModel& model = this->model();
  model.add_watch("height");
  model.add_breakpoint("step==59");
  model.stop_at_watch(0, Change::any);
  std::vector<std::uint32_t> expected;
  for (std::uint32_t step = 2; step < 59; ++step)
    if (model.run().rows()[step - 1].statistics.height != model.run().rows()[step - 2].statistics.height)
      expected.push_back(step);
  ASSERT_GT(expected.size(), 2U);
  for (const std::uint32_t step : expected) {
    model.run_to_breakpoint(true);
    ASSERT_EQ(model.run().position(), Position::end_of(step)) << model.message;
    EXPECT_EQ(model.message, "stopped at step " + std::to_string(step) + ": height has changed");
  }
  EXPECT_EQ(model.watches()[0].hits, expected.size());
  model.run_to_breakpoint(true);
  EXPECT_EQ(model.run().position(), Position::end_of(59)) << "the breakpoint is nearer";
  for (; !expected.empty(); expected.pop_back()) {
    model.run_to_breakpoint(false);
    ASSERT_EQ(model.run().position(), Position::end_of(expected.back())) << model.message;
  }
  model.stop_at_watch(0, std::nullopt);
  model.run_to_breakpoint(true);
  EXPECT_EQ(model.run().position(), Position::end_of(59)) << "it is only watched again";
}

TYPED_TEST(DebuggerModelTest, EveryEventIsReachedByItsKindBothWays) {
  DebuggerModel& model = this->model();
  for (const EventKind kind :
       {EventKind::balance, EventKind::shift_split, EventKind::split, EventKind::swap, EventKind::merge,
        EventKind::refused, EventKind::scheduled, EventKind::deferred, EventKind::placed, EventKind::phase}) {
    SCOPED_TRACE(to_string(kind));
    std::vector<Position> expected;
    for (std::uint32_t step = 1; step <= this->kSteps; ++step)
      for (const Event& event : model.run().events_of(step))
        if (kind_of_event(event) == kind) expected.push_back({step, event.id});
    EXPECT_EQ(expected.empty(), kind == EventKind::merge) << "the crowd leaves no node empty";
    if (expected.size() > 40) expected.resize(40);
    model.go({});
    for (const Position& there : expected) {
      model.go_to_kind(kind, true);
      ASSERT_EQ(model.run().position(), there);
      ASSERT_EQ(model.timeline.kind, kind);
    }
    for (; expected.size() > 1; expected.pop_back()) {
      ASSERT_EQ(model.run().position(), expected.back());
      model.go_to_kind(kind, false);
    }
  }
}

TYPED_TEST(DebuggerModelTest, OneSelectionAndWhatIsHidden) {
  DebuggerModel& model = this->model();
  model.select_object(ObjectId{5}, false);
  model.select_object(ObjectId{2}, true);
  EXPECT_EQ(to_string(model.selection(), {}), "pair 2,5");
  model.select(NodeId{0});
  EXPECT_TRUE(model.is_selected(NodeId{0}));
  model.toggle_hidden();
  EXPECT_TRUE(model.view.hidden_nodes.contains(NodeId{0}));
  model.toggle_hidden();
  EXPECT_TRUE(model.view.hidden_nodes.empty());
  model.toggle_isolated();
  EXPECT_EQ(model.view.isolated, NodeId{0});
  model.show_all();
  EXPECT_EQ(model.view.isolated, std::nullopt);
}

TYPED_TEST(DebuggerModelTest, RibbonsAreTheHistoryOfWhatIsSelected) {
  DebuggerModel& model = this->model();
  EXPECT_TRUE(model.ribbons().empty());
  const Position split = this->first("op==split && kind==acted");
  model.go(split);
  const NodeId node = model.run().tree()[*model.run().event_node()].left;
  model.select(node);
  const auto count = [&](auto... kinds) {
    return static_cast<std::size_t>(std::ranges::count_if(
        model.ribbons(), [&](const Ribbon& ribbon) { return ((ribbon.kind == kinds) || ...); }));
  };
  using Kind = Ribbon::Kind;
  EXPECT_EQ(count(Kind::listed, Kind::refused, Kind::acted), model.run().history(node).size());
  EXPECT_EQ(count(Kind::life), model.run().lives(node).size());
  ASSERT_FALSE(model.ribbons().empty());
  EXPECT_EQ(model.ribbons().front().kind, Kind::life);
  EXPECT_EQ(model.ribbons().front().first_step, split.step) << "the split of its parent has made it";
  model.go(Position::end_of(40));
  const Pair pair = make_pair(model.run().pairs()[0].a, model.run().pairs()[0].b);
  model.select(pair);
  bool is_now = false;
  for (const Ribbon& ribbon : model.ribbons()) is_now |= ribbon.first_step <= 40 && 40 <= ribbon.last_step;
  EXPECT_TRUE(is_now);
}

TYPED_TEST(DebuggerModelTest, TheOracleFindsNothingInAnExactTree) {
  DebuggerModel& model = this->model();
  model.go(Position::end_of(40));
  ASSERT_TRUE(model.alarms().contains(40));
  EXPECT_FALSE(model.alarms().at(40).is_wrong());
  EXPECT_EQ(model.run().judged_pairs(), model.run().pairs().size());
}

TYPED_TEST(DebuggerModelTest, PlayingGoesOnWithTime) {
  DebuggerModel& model = this->model();
  model.speed = 10;
  model.playing = true;
  model.pass_time(0.55);
  EXPECT_EQ(model.run().position(), Position::end_of(5));
  model.pass_time(0.05);
  EXPECT_EQ(model.run().position(), Position::end_of(6));
  model.pass_time(100);
  EXPECT_FALSE(model.playing) << "it stops at the end";
}

TYPED_TEST(DebuggerModelTest, PlayingByOperatorsStaysInItsRange) {
  DebuggerModel& model = this->model();
  model.timeline.range = StepSpan{20, 24};
  model.toggle_loop();
  model.plays_by = Granularity::op;
  std::vector<Position> expected;
  for (std::uint32_t step = 20; step <= 24; ++step)
    for (const Event& event : model.run().events_of(step))
      if (is_outcome(event)) expected.push_back({step, event.id});
  ASSERT_GT(expected.size(), 2U);
  model.playing = true;
  for (int round = 0; round < 2; ++round)
    for (const Position& there : expected) {
      model.pass_time(1 / model.speed);
      ASSERT_EQ(model.run().position(), there);
    }
  model.timeline.range = StepSpan{1, 1};
  model.pass_time(1 / model.speed);
  EXPECT_FALSE(model.playing) << "no operator acts in the first step";
  EXPECT_EQ(model.run().position(), Position());
  EXPECT_THAT(model.message, HasSubstr("the range has nothing"));
}

TYPED_TEST(DebuggerModelTest, WhatIfRefusesAnOperatorAndComparesFromThere) {
  DebuggerModel& model = this->model();
  model.go(this->first("op==split && kind==acted"));
  const Position split = model.run().position();
  model.what_if({.event = split.event});
  ASSERT_NE(model.other(), nullptr);
  ASSERT_TRUE(model.comparison().events);
  EXPECT_EQ(model.comparison().events->step, split.step);
  EXPECT_EQ(model.comparison().requests, std::nullopt);
  model.go(Position::end_of(split.step));
  EXPECT_EQ(model.other()->position(), Position::end_of(split.step));
  EXPECT_NE(model.other()->state_hash(), model.run().state_hash());
  const std::uint64_t others = model.other()->state_hash();
  model.change_over();
  EXPECT_EQ(model.run().state_hash(), others);
}

TYPED_TEST(DebuggerModelTest, TheOtherRunFollowsBelowTheStep) {
  DebuggerModel& model = this->model();
  model.go(this->first("op==split && kind==acted"));
  const Position split = model.run().position();
  model.what_if({.event = split.event});
  using Match = Counterpart::Match;
  EXPECT_EQ(model.match(), Match::different);
  const auto other_event = model.other()->event();
  ASSERT_TRUE(other_event);
  EXPECT_NE(refused_of(*other_event), nullptr);
  model.go(Position::end_of(split.step - 1));
  std::vector<std::pair<Position, std::uint64_t>> places;
  for (; model.run().position() < split; model.step(Granularity::event, true)) {
    ASSERT_EQ(model.match(), Match::same) << to_string(model.run().position(), {});
    ASSERT_EQ(model.other()->position(), model.run().position());
    ASSERT_EQ(model.other()->state_hash(), model.run().state_hash());
  }
  for (int k = 0; k < 40; ++k) {
    places.emplace_back(model.other()->position(), model.other()->state_hash());
    model.step(Granularity::event, true);
  }
  for (; !places.empty(); places.pop_back()) {
    model.step(Granularity::event, false);
    ASSERT_EQ(model.other()->position(), places.back().first);
    ASSERT_EQ(model.other()->state_hash(), places.back().second);
  }
}

TYPED_TEST(DebuggerModelTest, BothGoToTheFirstDifferentOperator) {
  DebuggerModel& model = this->model();
  model.go(this->first("op==split && kind==acted && step>20"));
  const Position split = model.run().position();
  model.what_if({.event = split.event});
  model.go(Position::end_of(2));
  model.go_to_first_different_operator();
  EXPECT_EQ(model.run().position(), split);
  ASSERT_TRUE(model.other()->event());
  EXPECT_EQ(model.other()->event()->body, model.comparison().operators->b->body);
  const std::uint64_t others = model.other()->state_hash();
  model.change_over();
  EXPECT_EQ(model.run().state_hash(), others) << "it goes on where the other one stood";
  EXPECT_EQ(model.other()->position(), split);
  model.compare_with(open_run(model.run().path()));
  model.go_to_first_different_operator();
  EXPECT_THAT(model.message, HasSubstr("no operator"));
}

TYPED_TEST(DebuggerModelTest, WhatIfTakesAnotherCandidateOrParameter) {
  DebuggerModel& model = this->model();
  model.go(this->first("op==split && kind==acted"));
  ASSERT_GT(model.run().ballot().size(), 1U);
  EXPECT_EQ(model.run().ballot()[0].entry.result, Ballot::chosen);
  EXPECT_FALSE(model.run().strip(0).intervals.empty());
  model.what_if({.event = model.run().position().event, .candidate = 1});
  ASSERT_TRUE(model.comparison().events);
  EXPECT_EQ(model.comparison().events->step, model.run().position().step);
  model.what_if({.assignments = "merge=0", .from = 30});
  EXPECT_TRUE(!model.comparison().events || model.comparison().events->step >= 30);
  EXPECT_THROW(model.what_if({.assignments = "nothing=1", .from = 30}), std::invalid_argument);
}

TYPED_TEST(DebuggerModelTest, Algorithm1StandsAtTheLineOfTheEvent) {
  DebuggerModel& model = this->model();
  model.go(this->first("op==split && kind==scheduled"));
  EXPECT_EQ(trace_algorithm_1(model.run()).line, 9);
  model.go(this->first("op==split && kind==acted"));
  const Algorithm1Trace trace = trace_algorithm_1(model.run());
  EXPECT_EQ(trace.line, 15);
  EXPECT_THAT(trace.decided[14], HasSubstr("split n"));
  model.go(this->first("op==swap && kind==acted"));
  EXPECT_EQ(trace_algorithm_1(model.run()).line, 16);
  model.go(this->first("op==balance && kind==acted"));
  EXPECT_EQ(trace_algorithm_1(model.run()).line, 5);
  model.step(Granularity::step, true);
  EXPECT_EQ(trace_algorithm_1(model.run()).line, 0);
}

TEST(OpenRun, SaysWhatCannotBeRead) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "text";
  std::ofstream(path) << "no recording";
  EXPECT_THROW((void)open_run(path), std::runtime_error);
}

}  // namespace
}  // namespace kerf
