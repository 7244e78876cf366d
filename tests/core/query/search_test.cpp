#include "core/query/search.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/query/recorded_moment.h"
#include "core/replay/cursor.h"
#include "core/trace/event_facts.h"
#include "tests/support/dimensions.h"
#include "tests/support/pairs.h"
#include "tests/support/recorded_crowd.h"
#include "tests/support/tampering.h"

namespace kerf {
namespace {

template <class T>
class SearchTest : public testing::Test {
 protected:
  static constexpr int kDimension = T::value;

  SearchTest() {
    test::record_crowd<kDimension>(file_.path(), 60, test::busy_config());
    recording_ = std::make_shared<RecordingReader<kDimension>>(file_.path());
  }

  /// All moments forwards; backwards there must be the same.
  std::vector<Position> find_all(const char* text) {
    const Expression expression = Expression::parse(text);
    Search<kDimension> search(recording_);
    std::vector<Position> found;
    for (auto at = search.forward(expression, Position::end_of(0)); at; at = search.forward(expression, *at))
      found.push_back(*at);
    std::vector<Position> back;
    for (auto at = search.backward(expression, Position::end_of(61)); at;
         at = search.backward(expression, *at))
      back.push_back(*at);
    std::ranges::reverse(back);
    EXPECT_EQ(found, back) << text;
    return found;
  }

  /// The moments at which `wanted(cursor)` holds, by going there; in steps or in events.
  template <class Wanted>
  std::vector<Position> walk(Granularity granularity, Wanted wanted) {
    Cursor<kDimension> cursor(recording_);
    std::vector<Position> found;
    while (cursor.forward(granularity))
      if (wanted(cursor)) found.push_back(cursor.position());
    return found;
  }

  test::TemporaryRecording file_;
  std::shared_ptr<RecordingReader<kDimension>> recording_;
};
TYPED_TEST_SUITE(SearchTest, test::Dimensions, test::DimensionNames);

TYPED_TEST(SearchTest, WhatTheRecordingCannotHaveIsRefused) {
  Search<TypeParam::value> search(this->recording_);
  for (const char* const text : {"object(-3) moves", "pair(99999999999,1)", "pairs>0 && pair(1,-2) leaves",
                                 "pair(5,61234)", "object(61234) moves"})
    EXPECT_THROW((void)search.forward(Expression::parse(text), Position::end_of(0)), std::invalid_argument)
        << text;
}

/// Objects that came after the last keyframe and went again, too, but not the number after the last one.
TYPED_TEST(SearchTest, EveryObjectThatTheRecordingHasCanBeNamed) {
  constexpr int kD = TypeParam::value;
  Cursor<kD> cursor(this->recording_);
  cursor.go_to_step(60);
  const std::size_t bound = cursor.state().latest.bound();
  Search<kD> search(this->recording_);
  const auto name = [](std::size_t id) {
    return Expression::parse("object(" + std::to_string(id) + ") moves");
  };
  for (std::size_t id = 0; id < bound; ++id) EXPECT_NO_THROW(search.check(name(id))) << id;
  try {
    search.check(name(bound));
    ADD_FAILURE() << bound;
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()), "the recording has no object " + std::to_string(bound) +
                                             "; it has 0 to " + std::to_string(bound - 1));
  }
}

TYPED_TEST(SearchTest, OperatorsAtADepth) {
  constexpr int kD = TypeParam::value;
  const auto expected = this->walk(Granularity::op, [](const Cursor<kD>& cursor) {
    const auto event = cursor.event();
    const auto* acted = acted_of(*event);
    return acted != nullptr && acted->op == Operator::split &&
           cursor.state().tree[acted->node.node].depth > 1;
  });
  EXPECT_GT(expected.size(), 3U);
  EXPECT_EQ(this->find_all("kind==acted && op==split && depth>1"), expected);
}

TYPED_TEST(SearchTest, PlanesThatMoveAndNodesThatChange) {
  constexpr int kD = TypeParam::value;
  const auto moves = [](const Cursor<kD>& cursor) {
    const auto event = cursor.event();
    const auto* acted = event ? acted_of(*event) : nullptr;
    return acted != nullptr && acted->node.node == NodeId{0} && acted->op != Operator::merge &&
           acted->op != Operator::swap;
  };
  const auto expected = this->walk(Granularity::op, moves);
  EXPECT_GT(expected.size(), 0U);
  EXPECT_EQ(this->find_all("plane(n0) moves"), expected);
  EXPECT_GE(this->find_all("node(n0)").size(), expected.size());
}

TYPED_TEST(SearchTest, PairsThatEnterAndLeave) {
  constexpr int kD = TypeParam::value;
  Cursor<kD> cursor(this->recording_);
  cursor.go_to_step(30);
  ASSERT_FALSE(cursor.state().pairs.empty());
  const Pair pair = cursor.state().pairs.front();
  const std::string name = "pair(" + std::to_string(pair.a.value) + "," + std::to_string(pair.b.value) + ")";
  std::vector<bool> is(61, false);
  const auto present = this->walk(Granularity::step, [&](const Cursor<kD>& at) {
    const auto pairs = test::sorted(at.state().pairs);
    is[at.position().step] = std::ranges::binary_search(pairs, pair);
    return is[at.position().step];
  });
  EXPECT_EQ(this->find_all(name.c_str()), present);
  std::vector<Position> enters;
  std::vector<Position> leaves;
  for (std::uint32_t step = 1; step <= 60; ++step) {
    if (is[step] && !is[step - 1]) enters.push_back(Position::end_of(step));
    if (!is[step] && is[step - 1]) leaves.push_back(Position::end_of(step));
  }
  EXPECT_FALSE(enters.empty());
  EXPECT_EQ(this->find_all((name + " enters").c_str()), enters);
  EXPECT_EQ(this->find_all((name + " leaves").c_str()), leaves);
}

TYPED_TEST(SearchTest, FiguresOfSteps) {
  const auto rows = this->recording_->rows();
  const auto expected = [&](auto wanted) {
    std::vector<Position> found;
    for (const StepRow& row : rows)
      if (wanted(row)) found.push_back(Position::end_of(row.step));
    return found;
  };
  const auto redundant = expected([](const StepRow& row) { return row.statistics.redundancy > 0.3; });
  EXPECT_FALSE(redundant.empty());
  EXPECT_LT(redundant.size(), 60U);
  EXPECT_EQ(this->find_all("redundancy>0.3"), redundant);
  EXPECT_EQ(this->find_all("deferred>1"),
            expected([](const StepRow& row) { return row.statistics.deferred > 1; }));
  const double median = row_median(rows, Variable::step_time);
  EXPECT_EQ(this->find_all("step_time>1.5*median"),
            expected([&](const StepRow& row) { return row.seconds() > 1.5 * median; }));
}

TYPED_TEST(SearchTest, TheOracleFindsNothingMissedAndWhatIsPlantedInAnImport) {
  constexpr int kD = TypeParam::value;
  EXPECT_TRUE(this->find_all("missed>0 || extra>0 || twice>0").empty());
  this->recording_.reset();
  this->file_.change(
      "INSERT INTO their_steps VALUES(17, 5, 1, 0, 2, 3); INSERT INTO their_seals VALUES(17, 0); "
      "INSERT INTO their_verdicts VALUES(17, 0, 1, 'undecided'); "
      "UPDATE meta SET value='1' WHERE key='imported'");
  test::reseal(this->file_.path());
  this->recording_ = std::make_shared<RecordingReader<kD>>(this->file_.path());
  EXPECT_EQ(this->find_all("missed>0"), std::vector{Position::end_of(17)});
  EXPECT_EQ(this->find_all("twice==2"), std::vector{Position::end_of(17)});
  EXPECT_EQ(this->find_all("ignored==3"), std::vector{Position::end_of(17)});
  EXPECT_EQ(this->find_all("undecided==1"), std::vector{Position::end_of(17)});
  EXPECT_TRUE(this->find_all("extra>0").empty());
}

TYPED_TEST(SearchTest, ObjectsThatMoveAndPhasesThatBegin) {
  EXPECT_GT(this->find_all("object(3) moves").size(), 3U);
  EXPECT_EQ(this->find_all("phase==sweep").size(), 60U);
  EXPECT_EQ(this->find_all("phase==sweep && step>50").size(), 10U);
  EXPECT_FALSE(this->find_all("kind==refused || kind==deferred").empty());
}

/// By the definition: from the values at all moments.
TYPED_TEST(SearchTest, ValuesThatChangeAreFoundAtTheSameMomentsBothWays) {
  constexpr int kD = TypeParam::value;
  for (const char* const text : {"height", "deferred>1", "depth", "population", "pair(1,2)", "missed"}) {
    for (const Change change : {Change::any, Change::becomes_true}) {
      SCOPED_TRACE(text);
      const Expression expression = Expression::parse_value(text);
      Search<kD> search(this->recording_);
      std::vector<Position> expected;
      std::optional<ConditionNumber> before;
      (void)this->walk(
          expression.asks_events() ? Granularity::event : Granularity::step, [&](const Cursor<kD>& at) {
            const ConditionNumber now = search.value(expression, at.position());
            if (!now.exists() || (expression.asks_events() && at.position().is_end())) return false;
            const bool was = before && before->is_true();
            const bool changes = change == Change::any ? before && *before != now : now.is_true() && !was;
            if (changes) expected.push_back(at.position());
            before = now;
            return false;
          });
      std::vector<Position> found;
      Position at;
      while (const auto next = search.forward_change(expression, at, change)) found.push_back(at = *next);
      EXPECT_EQ(found, expected);
      found.clear();
      at = Position::end_of(61);
      while (const auto next = search.backward_change(expression, at, change)) found.push_back(at = *next);
      EXPECT_EQ(found, std::vector<Position>(expected.rbegin(), expected.rend()));
    }
  }
}

TYPED_TEST(SearchTest, CanBeStopped) {
  Search<TypeParam::value> search(this->recording_);
  std::uint32_t asked = 0;
  const auto stop = [&](std::uint32_t /*step*/) { return ++asked < 5; };
  EXPECT_EQ(search.forward(Expression::parse("missed>0"), Position::end_of(0), stop), std::nullopt);
  EXPECT_EQ(asked, 5U);
}

/// Their floats touch in every step; in doubles they touch in the second one only.
TYPED_TEST(SearchTest, BoxesInDoublesAreAPairAsTheyWereGiven) {
  constexpr int kD = TypeParam::value;
  GivenBox<kD> a;
  for (std::size_t axis = 0; axis < kD; ++axis) a.min[axis] = 0;
  for (std::size_t axis = 0; axis < kD; ++axis) a.max[axis] = 1;
  GivenBox<kD> b = a;
  b.max[0] = 2;
  const test::TemporaryRecording file;
  RecordingInfo info = test::info_of<kD>(test::busy_config());
  info.imported = true;
  Bsp<kD, EventLog> tree(info.config);
  Recorder<kD> recorder(tree, file.path(), info);
  (void)recorder.insert({0}, round_outward(a), Mobility::moving);
  for (const double begin : {1 + 1e-12, 1.0, 1 + 1e-12}) {
    b.min[0] = begin;
    (void)(tree.steps() == 0 ? recorder.insert({1}, round_outward(b), Mobility::moving)
                             : recorder.move({1}, round_outward(b)));
    recorder.step();
    recorder.add_theirs(TheirChanges<kD>{{{{0}, a}, {{1}, b}}, {}});
  }
  recorder.finish();
  this->recording_ = std::make_shared<RecordingReader<kD>>(file.path());
  EXPECT_EQ(this->find_all("pair(0,1)"), std::vector{Position::end_of(2)});
  EXPECT_EQ(this->find_all("pair(1,0) enters"), std::vector{Position::end_of(2)});
  EXPECT_EQ(this->find_all("pair(0,1) leaves"), std::vector{Position::end_of(3)});
  Search<kD> search(this->recording_);
  const Expression enters = Expression::parse("pair(0,1) enters");
  EXPECT_TRUE(search.value(enters, Position::end_of(2)).is_true());
  EXPECT_FALSE(search.value(enters, Position::end_of(3)).is_true());
}

}  // namespace
}  // namespace kerf
