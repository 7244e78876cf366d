#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/query/compare.h"
#include "core/query/explain_event.h"
#include "core/query/explain_node.h"
#include "core/query/explain_pair.h"
#include "core/replay/cursor.h"
#include "core/replay/oracle.h"
#include "core/trace/event_facts.h"
#include "tests/support/dimensions.h"
#include "tests/support/recorded_crowd.h"

namespace kerf {
namespace {

using ::testing::HasSubstr;

template <class T>
class Explain : public testing::Test {
 protected:
  static constexpr int kDimension = T::value;

  Explain() {
    test::record_crowd<kDimension>(file_.path(), 60, test::busy_config());
    recording_ = std::make_shared<RecordingReader<kDimension>>(file_.path());
  }

  test::TemporaryRecording file_;
  Replayer<kDimension>& replayer() {
    if (!replayer_) replayer_ = std::make_unique<Replayer<kDimension>>(recording_);
    return *replayer_;
  }

  std::shared_ptr<RecordingReader<kDimension>> recording_;
  std::unique_ptr<Replayer<kDimension>> replayer_;
};
TYPED_TEST_SUITE(Explain, test::Dimensions, test::DimensionNames);

/// Every answer is held against the tree and the definition.
TYPED_TEST(Explain, PairsAndNoPairs) {
  constexpr int kD = TypeParam::value;
  Cursor<kD> cursor(this->recording_);
  cursor.go_to_step(40);
  const BspState<kD>& state = cursor.state();
  const std::vector<Pair> truth = oracle_pairs(state.latest);
  std::uint32_t separated_by_planes = 0;
  for (std::uint32_t b = 1; b < 60; ++b) {
    const Pair pair{{b / 7}, {b}};
    if (pair.a >= pair.b || !state.latest.is_placed(pair.a) || !state.latest.is_placed(pair.b)) continue;
    const auto why = explain_pair(this->replayer(), 40, pair);
    const bool is = std::ranges::binary_search(truth, pair);
    EXPECT_EQ(why.is_pair, is);
    EXPECT_EQ(why.reported, is);
    EXPECT_EQ(why.boxes_overlap, why.margin <= 0);
    EXPECT_EQ(!why.history.empty() && why.history.back().is_pair, is);
    EXPECT_TRUE(!is || why.shared_leaf);
    if (!why.shared_leaf) {
      ++separated_by_planes;
      const HalfSpaceTest<kD>& last = why.tests.back();
      EXPECT_FALSE((last.a_sides.left && last.b_sides.left) || (last.a_sides.right && last.b_sides.right));
      EXPECT_THAT(to_text(why, {}), HasSubstr("separates them: along its normal"));
    } else {
      EXPECT_THAT(to_text(why, {}), HasSubstr("where they are compared; together there since e"));
    }
  }
  EXPECT_GT(separated_by_planes, 0U);
  const Pair pair = truth.front();
  EXPECT_THAT(to_text(explain_pair(this->replayer(), 40, pair), {}),
              HasSubstr("are a pair: their boxes overlap on every axis"));
}

TYPED_TEST(Explain, PairsAreCalledByTheirLabels) {
  RecordingInfo info = this->recording_->info();
  info.marks.set({3}, {"left wheel", std::nullopt});
  const std::string text = to_text(explain_pair(this->replayer(), 40, {{3}, {8}}), info);
  EXPECT_THAT(text, HasSubstr("after step 40, 3 left wheel and 8 are "));
  EXPECT_THAT(text, HasSubstr("\n  3 left wheel: x ["));
}

/// Right before the event they did not share the leaf, right after it they do.
TYPED_TEST(Explain, TheEventThatBroughtTwoTogether) {
  constexpr int kD = TypeParam::value;
  Cursor<kD> cursor(this->recording_);
  cursor.go_to_step(50);
  const std::vector<Pair> truth = oracle_pairs(cursor.state().latest);
  const auto together = [&](const Pair& pair, NodeId leaf) {
    const Tree<kD>& tree = cursor.state().tree;
    const auto has = [&](ObjectId object) {
      return std::ranges::any_of(tree[leaf].entries,
                                 [&](const Entry& entry) { return entry.object == object; });
    };
    return leaf.index() < tree.slots() && has(pair.a) && has(pair.b);
  };
  for (std::size_t k = 0; k < std::min<std::size_t>(truth.size(), 10); ++k) {
    const auto why = explain_pair(this->replayer(), 50, truth[k]);
    ASSERT_TRUE(why.shared_since);
    cursor.go_to_event(why.shared_since->id);
    EXPECT_TRUE(together(truth[k], *why.shared_leaf)) << describe(*why.shared_since, {});
    ASSERT_TRUE(cursor.backward(Granularity::event));
    EXPECT_FALSE(together(truth[k], *why.shared_leaf)) << describe(*why.shared_since, {});
  }
}

TYPED_TEST(Explain, ObjectsThatAreNotThereOrInQuarantine) {
  EXPECT_THAT(to_text(explain_pair(this->replayer(), 40, {{1}, {900}}), {}),
              HasSubstr("object 900 is not there"));
  Replayer<TypeParam::value> replayer(this->recording_);
  replayer.seek(4);  // in which boxes are broken
  const auto& objects = replayer.tree().objects();
  for (std::uint32_t id = 0; id < objects.bound(); ++id) {
    if (objects.state({id}) != ObjectState::quarantined) continue;
    const Pair pair = make_pair({id}, {id == 0 ? 1U : 0U});
    EXPECT_THAT(to_text(explain_pair(this->replayer(), 4, pair), {}), HasSubstr("is in quarantine"));
    return;
  }
  FAIL() << "no box was broken";
}

TYPED_TEST(Explain, NodesAndTheirHistory) {
  constexpr int kD = TypeParam::value;
  Cursor<kD> cursor(this->recording_);
  cursor.go_to_step(60);
  const Tree<kD>& tree = cursor.state().tree;
  const auto root = explain_node(this->replayer(), 60, tree.root());
  EXPECT_TRUE(root.alive);
  EXPECT_TRUE(root.path.empty());
  ASSERT_TRUE(root.quality);
  EXPECT_EQ(root.quality->population, tree.objects());
  EXPECT_FALSE(root.history.empty());
  for (const Event& event : root.history)
    EXPECT_THAT(describe(event, {}), HasSubstr("n" + std::to_string(tree.root().value)));
  for_each_node(tree, tree.root(), [&](NodeId id) {
    const auto node = explain_node(this->replayer(), 60, id);
    EXPECT_EQ(node.path.size(), tree[id].depth);
    EXPECT_EQ(node.quality.has_value(), !tree[id].is_leaf());
    ASSERT_EQ(node.lives.size(), tree[id].generation + 1);
    EXPECT_FALSE(node.lives.back().span.last_step);
  });
  EXPECT_THAT(to_text(root, {}), HasSubstr("from "));
  EXPECT_FALSE(explain_node(this->replayer(), 60, {tree.slots() + 5}).alive);
  EXPECT_THAT(to_text(explain_node(this->replayer(), 60, {tree.slots() + 5}), {}),
              HasSubstr("has never been used"));
}

TYPED_TEST(Explain, WhatTriggeredAnOperator) {
  constexpr int kD = TypeParam::value;
  Cursor<kD> cursor(this->recording_);
  std::uint32_t splits = 0;
  std::uint32_t balances = 0;
  while (cursor.forward(Granularity::op)) {
    const auto event = cursor.event();
    const auto* acted = acted_of(*event);
    if (acted == nullptr) continue;
    const auto why = explain_event(this->replayer(), event->id);
    if (acted->op == Operator::split && ++splits < 8) {
      EXPECT_THAT(why.reason,
                  HasSubstr("crowded: it has " + std::to_string(acted->before.population) + " objects"));
      ASSERT_TRUE(why.scheduled);
      EXPECT_LT(why.scheduled->id, event->id);
      EXPECT_EQ(why.ballot.front().direction, acted->direction);
      EXPECT_THAT(to_text(why, {}), HasSubstr("; chosen"));
    }
    if (acted->op == Operator::balance && ++balances < 8) {
      EXPECT_FALSE(why.scheduled);  // it acts at once
      EXPECT_THAT(why.reason, ::testing::AnyOf(HasSubstr("unbalanced"), HasSubstr("cut through")));
    }
  }
  EXPECT_GT(splits, 0U);
  EXPECT_GT(balances, 0U);
  EXPECT_THROW((void)explain_event(this->replayer(), 99999999), std::runtime_error);
}

/// Those that acted or were refused in the whole run.
template <int D>
std::vector<Event> operators_of(RecordingReader<D>& recording) {
  std::vector<Event> operators;
  for (std::uint32_t step = 1; step <= recording.steps(); ++step)
    for (const Event& event : recording.step(step).events)
      if (is_outcome(event)) operators.push_back(event);
  return operators;
}

TYPED_TEST(Explain, WhereTwoRecordingsDiffer) {
  constexpr int kD = TypeParam::value;
  const test::TemporaryRecording same;
  const test::TemporaryRecording other;
  test::record_crowd<kD>(same.path(), 60, test::busy_config());
  Config config = test::busy_config();
  config.min_balance = 0.3F;
  test::record_crowd<kD>(other.path(), 60, config);
  RecordingReader<kD> b(same.path());
  RecordingReader<kD> c(other.path());
  EXPECT_TRUE(compare(*this->recording_, b).same());
  const RecordingComparison comparison = compare(*this->recording_, c);
  EXPECT_FALSE(comparison.same());
  EXPECT_EQ(comparison.requests, std::nullopt);
  EXPECT_EQ(comparison.pairs, std::nullopt);  // both are exact
  ASSERT_TRUE(comparison.events);
  EXPECT_LE(comparison.events->step, *comparison.state);
  EXPECT_NE(comparison.events->a, comparison.events->b);
  ASSERT_TRUE(comparison.operators);
  EXPECT_GE(comparison.operators->step, comparison.events->step);
  const auto first = operators_of(*this->recording_);
  const auto second = operators_of(c);
  const auto [x, y] = std::ranges::mismatch(first, second, {}, &Event::body, &Event::body);
  ASSERT_TRUE(x != first.end() && x->step == y->step);
  EXPECT_EQ(comparison.operators->a, *x);
  EXPECT_EQ(comparison.operators->b, *y);
  EXPECT_NE(comparison.a.operators, comparison.b.operators);
}

}  // namespace
}  // namespace kerf
