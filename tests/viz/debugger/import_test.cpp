#include <gmock/gmock.h>

#include <map>

#include "core/replay/judge_theirs.h"
#include "core/replay/oracle.h"
#include "tests/support/dimensions.h"
#include "tests/support/recorded_crowd.h"
#include "viz/debugger/model/debugger_model.h"
#include "viz/debugger/model/figure_table.h"

namespace kerf {
namespace {

using Steps = std::vector<std::uint32_t>;

constexpr std::uint32_t kSteps = 48;
const Steps kMissing{7, 30};
const Steps kAdding{12, 30, 41};
const Steps kRepeating{20, 41, kSteps};

bool has(const Steps& steps, std::uint32_t step) { return std::ranges::find(steps, step) != steps.end(); }

/// Two objects that do not overlap.
Pair no_pair(const std::vector<Pair>& truth) {
  for (std::uint32_t b = 1;; ++b)
    if (const Pair pair{{0}, {b}}; !std::ranges::binary_search(truth, pair)) return pair;
}

/// What an engine reports that is wrong in a few steps: it misses the first pair, reports one that is
/// none, or the last one again.
std::vector<Pair> reported(const std::vector<Pair>& truth, std::uint32_t step) {
  std::vector<Pair> pairs = truth;
  if (has(kRepeating, step)) pairs.push_back(pairs.back());
  if (has(kAdding, step)) pairs.push_back(no_pair(truth));
  if (has(kMissing, step)) pairs.erase(pairs.begin());
  return pairs;
}

/// Another engine's run, as `kerf import` writes it, and a model of it.
template <class T>
class ImportedRun : public testing::Test {
 protected:
  static constexpr int kD = T::value;

  ImportedRun() {
    Bsp<kD, EventLog> tree(test::busy_config());
    RecordingInfo info = test::info_of<kD>(test::busy_config());
    info.imported = true;
    Recorder<kD> recorder(tree, file_.path(), info);
    test::play_crowd<kD>(recorder, kSteps, 3, [&](std::uint32_t step) {
      const std::vector<Pair> truth = oracle_pairs(tree.objects());
      const std::vector<Pair> theirs = reported(truth, step);
      recorder.add_theirs(theirs, judge_theirs<kD>(theirs, truth, tree.objects(), TheirWorld<kD>(), {}));
    });
    recorder.finish();
    model_ = std::make_unique<DebuggerModel>(open_run(file_.path()));
  }
  [[nodiscard]] DebuggerModel& model() { return *model_; }

  /// The steps at which a run from one end to the other stops.
  Steps stops(const std::string& condition, bool forwards) {
    model_->breakpoints.clear();
    model_->add_breakpoint(condition);
    model_->step(Granularity::run, !forwards);
    Steps stops;
    for (std::uint32_t hits = 0;; hits = model_->breakpoints[0].hits) {
      model_->run_to_breakpoint(forwards);
      if (model_->breakpoints[0].hits == hits) return stops;
      EXPECT_TRUE(model_->run().position().is_end());
      EXPECT_TRUE(model_->run().value(Expression::parse(condition)).is_true());
      stops.push_back(model_->run().position().step);
    }
  }

 private:
  test::TemporaryRecording file_;
  std::unique_ptr<DebuggerModel> model_;
};
TYPED_TEST_SUITE(ImportedRun, test::Dimensions, test::DimensionNames);

TYPED_TEST(ImportedRun, BreakpointsStopWhereTheirPairsAreWrongBothWays) {
  const std::map<std::string, Steps> expected{
      {"missed>0", kMissing},        {"extra>0", kAdding},
      {"twice>0", kRepeating},       {"missed>0 && extra>0", {30}},
      {"extra>0 && twice==1", {41}}, {"missed>0 || extra>0 || twice>0", {7, 12, 20, 30, 41, kSteps}},
  };
  for (const auto& [condition, steps] : expected) {
    SCOPED_TRACE(condition);
    EXPECT_EQ(this->stops(condition, true), steps);
    Steps reverse(steps.rbegin(), steps.rend());
    std::erase(reverse, kSteps);  // there it stands already
    EXPECT_EQ(this->stops(condition, false), reverse);
  }
}

TYPED_TEST(ImportedRun, TheNextAlarmIsFoundWithoutAskingTheOracleFirst) {
  DebuggerModel& model = this->model();
  model.asks_oracle = false;
  const Steps alarms{7, 12, 20, 30, 41, kSteps};
  for (const std::uint32_t step : alarms) {
    model.go_to_kind(EventKind::alarm, true);
    EXPECT_EQ(model.run().position(), Position::end_of(step));
  }
  model.go_to_kind(EventKind::alarm, true);
  EXPECT_EQ(model.message, "nothing of the kind 'alarm' further on");
  model.go_to_kind(EventKind::alarm, false);
  EXPECT_EQ(model.run().position(), Position::end_of(41));
}

TYPED_TEST(ImportedRun, AllStepsAreJudgedBeforeAnyIsSeen) {
  DebuggerModel& model = this->model();
  EXPECT_EQ(model.run().position().step, 0U);
  for (std::uint32_t step = 1; step <= kSteps; ++step) EXPECT_TRUE(model.alarms().contains(step)) << step;
  EXPECT_THAT(model.wrong_steps(), testing::ElementsAre(7, 12, 20, 30, 41, kSteps));
}

TYPED_TEST(ImportedRun, ErrorsAreGoneToOneAfterAnotherBothWays) {
  DebuggerModel& model = this->model();
  const std::vector<WrongPair>& all = model.run().wrong_pairs();
  ASSERT_EQ(all.size(), kMissing.size() + kAdding.size() + kRepeating.size());
  EXPECT_TRUE(std::ranges::is_sorted(all));
  for (std::size_t k = 0; k < all.size(); ++k) {
    ASSERT_TRUE(model.go_to_error(true)) << k;
    EXPECT_EQ(model.wrong_pair(), k);
    EXPECT_EQ(model.run().position(), Position::end_of(all[k].step));
    EXPECT_EQ(model.selection(), Selection(all[k].pair));
  }
  EXPECT_FALSE(model.go_to_error(true));
  EXPECT_EQ(model.message, "there is no error further on");
  for (std::size_t k = all.size() - 1; k > 0; --k) {
    ASSERT_TRUE(model.go_to_error(false)) << k;
    EXPECT_EQ(model.wrong_pair(), k - 1);
  }
  EXPECT_FALSE(model.go_to_error(false));
  EXPECT_EQ(model.message, "there is no error further back");
}

TYPED_TEST(ImportedRun, ErrorsOfTheStepInSightComeFirst) {
  DebuggerModel& model = this->model();
  model.go(Position::end_of(30));
  ASSERT_TRUE(model.go_to_error(true));
  EXPECT_EQ(model.run().position().step, 30U);
  model.select({});
  ASSERT_TRUE(model.go_to_error(false));
  EXPECT_EQ(model.run().position().step, 30U);
  model.select({});
  model.go(Position::end_of(29));
  ASSERT_TRUE(model.go_to_error(false));
  EXPECT_EQ(model.run().position().step, 20U);
}

TEST(WrongPairs, APairThatIsWrongTwiceInAStepDoesNotHoldUpTheWalk) {
  const Pair pair{{0}, {1}};
  const std::vector<WrongPair> all{
      {2, pair, PairVerdict::extra}, {2, pair, PairVerdict::twice}, {3, pair, PairVerdict::missed}};
  WrongPairWalk walk;
  walk.arrive(*walk.beside(all, Position::end_of(2), pair, true));
  EXPECT_EQ(walk.here(all, Position::end_of(2), pair), 1U);
  EXPECT_EQ(walk.beside(all, Position::end_of(2), pair, true), 2U);
  EXPECT_EQ(walk.beside(all, Position::end_of(2), pair, false), 0U);
  EXPECT_FALSE(walk.here(all, Position::end_of(3), ObjectId{0}));
}

TYPED_TEST(ImportedRun, TheTableHasTheErrorsOfAllSteps) {
  kerf::Run& run = this->model().run();
  const FigureTable table = table_of_errors(run);
  ASSERT_EQ(table.rows.size(), run.wrong_pairs().size());
  for (const FigureTable::Row& row : table.rows) {
    const WrongPair& wrong = run.wrong_pairs()[*row.wrong_pair];
    EXPECT_EQ(row.item, Selection(wrong.pair));
    EXPECT_EQ(row.figures[0], wrong.step);
  }
  const auto by_step = find_rows(table, "", {1, false});
  for (std::size_t k = 1; k < by_step.size(); ++k)
    EXPECT_LE(table.rows[by_step[k - 1]].figures[0], table.rows[by_step[k]].figures[0]);
  const auto missed = find_rows(table, "missed", {1, false});
  ASSERT_EQ(missed.size(), kMissing.size());
  EXPECT_EQ(to_csv(to_texts(table, missed)), "pair,step,verdict\n\"" + table.rows[missed[0]].name +
                                                 "\",7,missed\n\"" + table.rows[missed[1]].name +
                                                 "\",30,missed\n");
}

/// As doubles, steps beyond 2^53 met their neighbours, and were shown with six digits.
TEST(StepsOfManyDigits, AreStoppedAtAndShownAsTheyWereGiven) {
  test::TemporaryRecording file;
  Bsp<2, EventLog> tree(test::busy_config());
  RecordingInfo info = test::info_of<2>(test::busy_config());
  info.imported = true;
  std::vector<std::string> steps;
  for (std::uint64_t step = 9'007'199'254'740'992; steps.size() < 4; ++step)
    steps.push_back(std::to_string(step));
  info.names = GivenNames({}, steps);
  Recorder<2> recorder(tree, file.path(), info);
  test::play_crowd<2>(recorder, 4, 3, [&](std::uint32_t /*step*/) {
    const std::vector<Pair> none;
    const std::vector<Pair> truth = oracle_pairs(tree.objects());
    recorder.add_theirs(none, judge_theirs<2>(none, truth, tree.objects(), TheirWorld<2>(), {}));
  });
  recorder.finish();
  DebuggerModel model(open_run(file.path()));
  model.go(Position::end_of(2));
  model.toggle_breakpoint_here();
  model.go(Position{});
  model.run_to_breakpoint(true);
  EXPECT_EQ(model.run().position(), Position::end_of(2));
  model.run_to_breakpoint(true);
  EXPECT_EQ(model.run().position(), Position::end_of(2)) << "no other step";
  model.add_watch("step");
  EXPECT_EQ(to_text(model.watches()[0].value), steps[1]);
  const FigureTable table = table_of_errors(model.run());
  ASSERT_FALSE(table.rows.empty());
  for (std::size_t row = 0; row < table.rows.size(); ++row)
    EXPECT_EQ(cell_text(table, row, 1),
              steps[model.run().wrong_pairs()[*table.rows[row].wrong_pair].step - 1]);
}

TYPED_TEST(ImportedRun, TheOracleMarksWhatIsWrongAndNothingElse) {
  DebuggerModel& model = this->model();
  for (std::uint32_t step = 1; step <= kSteps; ++step) {
    model.go(Position::end_of(step));
    ASSERT_TRUE(model.alarms().contains(step));
    const Alarm& alarm = model.alarms().at(step);
    EXPECT_EQ(alarm.missed, has(kMissing, step) ? 1U : 0U) << step;
    EXPECT_EQ(alarm.extra, has(kAdding, step) ? 1U : 0U) << step;
    EXPECT_EQ(alarm.twice, has(kRepeating, step) ? 1U : 0U) << step;
  }
  model.go(Position::end_of(30));
  const PairJudgement judgement = model.run().judgement();
  EXPECT_THAT(model.run().explain(judgement.missed.at(0)), testing::HasSubstr("other engine missed it"));
  EXPECT_THAT(model.run().explain(judgement.extra.at(0)),
              testing::HasSubstr("reported it, though it is none"));
}

}  // namespace
}  // namespace kerf
