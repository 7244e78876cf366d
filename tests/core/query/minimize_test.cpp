#include "core/query/minimize.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>
#include <stdexcept>

#include "core/bsp/bsp.h"
#include "core/query/delta_debug.h"
#include "tests/support/dimensions.h"
#include "tests/support/pairs.h"
#include "tests/support/recorded_crowd.h"

namespace kerf {
namespace {

using ::testing::ElementsAre;

TEST(DeltaDebug, LeavesWhatIsToBlame) {
  std::vector<int> items(100);
  std::iota(items.begin(), items.end(), 0);
  std::size_t calls = 0;
  const auto blames = [&](std::vector<int> guilty) {
    return delta_debug(items, [&calls, guilty](const std::vector<int>& rest) {
      ++calls;
      return std::ranges::includes(rest, guilty);
    });
  };
  EXPECT_THAT(blames({42}), ElementsAre(42));
  EXPECT_LT(calls, 40U);
  EXPECT_THAT(blames({3, 50, 99}), ElementsAre(3, 50, 99));
  EXPECT_EQ(blames(items), items);
  EXPECT_THAT(delta_debug(std::vector<int>{7}, [](const auto& /*rest*/) { return false; }), ElementsAre(7));
}

template <class T>
class Minimize : public testing::Test {
 protected:
  static constexpr int kDimension = T::value;

  Scenario<kDimension> crowd(VolumeKind kind = VolumeKind::box, std::uint32_t first = 0) {
    const test::TemporaryRecording file;
    test::record_crowd<kDimension>(file.path(), 40, test::busy_config(), kind);
    Replayer<kDimension> replayer(std::make_shared<RecordingReader<kDimension>>(file.path()));
    return scenario_of(replayer, first, 40);
  }
};
TYPED_TEST_SUITE(Minimize, test::Dimensions, test::DimensionNames);

/// The pairs after the last step.
template <int D>
std::vector<Pair> last_pairs(const Scenario<D>& scenario) {
  Bsp<D> tree(scenario.info.config, scenario.info.volume);
  for (const ScenarioStep<D>& step : scenario.steps) {
    apply(step.requests, tree);
    tree.set_config(step.config);
    tree.step();
  }
  return test::sorted(tree.pairs());
}

/// The first object moves, is broken, goes and comes again; the minimum says only where the two are.
TYPED_TEST(Minimize, APairNeedsTwoObjectsAndOneStep) {
  constexpr int kD = TypeParam::value;
  for (const VolumeKind kind : {VolumeKind::box, VolumeKind::sphere}) {
    const Scenario<kD> whole = this->crowd(kind);
    const Pair pair = last_pairs(whole).front();
    const auto fails = [&](const Scenario<kD>& scenario) {
      return std::ranges::binary_search(last_pairs(scenario), pair);
    };
    const Scenario<kD> small = minimize<kD>(whole, fails);
    EXPECT_TRUE(fails(small));
    EXPECT_EQ(small.steps.size(), 1U);
    EXPECT_THAT(objects_of(small), ElementsAre(pair.a, pair.b));
    EXPECT_LE(small.requests(), 4U);
  }
}

/// A subset of objects has those pairs of the whole that it can have.
TYPED_TEST(Minimize, LeavingOutObjectsKeepsThePairsOfTheOthers) {
  constexpr int kD = TypeParam::value;
  const Scenario<kD> whole = this->crowd();
  std::vector<ObjectId> even;
  for (const ObjectId object : objects_of(whole))
    if (object.value % 2 == 0) even.push_back(object);
  std::vector<Pair> expected;
  for (const Pair& pair : last_pairs(whole))
    if (pair.a.value % 2 == 0 && pair.b.value % 2 == 0) expected.push_back(pair);
  EXPECT_FALSE(expected.empty());
  EXPECT_TRUE(test::same_pairs(last_pairs(with_objects(whole, even)), expected));
}

TYPED_TEST(Minimize, StartingLateOrLeavingOutStepsEndsWithTheSamePairs) {
  constexpr int kD = TypeParam::value;
  const Scenario<kD> whole = this->crowd();
  const auto expected = last_pairs(whole);
  for (const std::uint32_t first : {1U, 5U, 17U, 39U, 40U}) {
    const Scenario<kD> late = this->crowd(VolumeKind::box, first);
    EXPECT_EQ(late.steps.size(), 41 - first);
    EXPECT_TRUE(test::same_pairs(last_pairs(late), expected)) << first;
  }
  const Scenario<kD> few = with_steps(whole, {4, 5, 30, 39});
  EXPECT_EQ(few.steps.size(), 4U);
  EXPECT_TRUE(test::same_pairs(last_pairs(few), expected));
}

TYPED_TEST(Minimize, StartsAsLateAsItStillFails) {
  constexpr int kD = TypeParam::value;
  const test::TemporaryRecording file;
  test::record_crowd<kD>(file.path(), 40, test::busy_config());
  Replayer<kD> replayer(std::make_shared<RecordingReader<kD>>(file.path()));
  const auto late =
      start_late<kD>(replayer, 40, [](const Scenario<kD>& scenario) { return scenario.steps.size() >= 8; });
  EXPECT_EQ(late.steps.size(), 9U);  // one in which all come, and the eight that were tried after four
  const auto all =
      start_late<kD>(replayer, 40, [](const Scenario<kD>& scenario) { return scenario.steps.size() == 40; });
  EXPECT_EQ(all.steps.size(), 40U);
}

/// What was returned did not show the condition.
TYPED_TEST(Minimize, WhatNoRunShowsIsRefused) {
  constexpr int kD = TypeParam::value;
  const test::TemporaryRecording file;
  test::record_crowd<kD>(file.path(), 40, test::busy_config());
  Replayer<kD> replayer(std::make_shared<RecordingReader<kD>>(file.path()));
  const auto never = [](const Scenario<kD>& /*any*/) { return false; };
  EXPECT_THROW((void)start_late<kD>(replayer, 40, never), std::runtime_error);
  int asked = 0;
  const auto seldom = [&](const Scenario<kD>& /*any*/) { return asked++ == 0; };
  EXPECT_THROW((void)minimize<kD>(this->crowd(), seldom), std::runtime_error);
}

/// Pairs of an object that has no box were left out at once, and nothing was found.
TYPED_TEST(Minimize, APairOfAnObjectWithoutABoxStays) {
  constexpr int kD = TypeParam::value;
  const Pair wrong{{3}, {99999}};
  Scenario<kD> whole = this->crowd();
  whole.steps[7].theirs = {{{1}, {2}}, wrong};
  const auto fails = [&](const Scenario<kD>& scenario) {
    return std::ranges::any_of(scenario.steps, [&](const ScenarioStep<kD>& step) {
      return step.theirs && std::ranges::find(*step.theirs, wrong) != step.theirs->end();
    });
  };
  const Scenario<kD> small = minimize<kD>(whole, fails);
  EXPECT_TRUE(fails(small));
  EXPECT_EQ(small.steps.size(), 1U);
  EXPECT_THAT(objects_of(small), ElementsAre(wrong.a, wrong.b));
}

TYPED_TEST(Minimize, AnOperatorNeedsACrowd) {
  constexpr int kD = TypeParam::value;
  const auto splits = [](const Scenario<kD>& scenario) {
    Bsp<kD> tree(scenario.info.config);
    for (const ScenarioStep<kD>& step : scenario.steps) {
      apply(step.requests, tree);
      tree.set_config(step.config);
      tree.step();
      if (tree.statistics().count(Operator::split) > 0) return true;
    }
    return false;
  };
  const Scenario<kD> whole = this->crowd();
  ASSERT_TRUE(splits(whole));
  const Scenario<kD> small = minimize<kD>(whole, splits);
  EXPECT_TRUE(splits(small));
  EXPECT_LT(small.requests(), whole.requests() / 10);
  EXPECT_GT(objects_of(small).size(), 6U);  // fewer are never split
  for (const ObjectId object : objects_of(small)) {
    auto fewer = objects_of(small);
    std::erase(fewer, object);
    EXPECT_FALSE(splits(with_objects(small, fewer))) << "without object " << object.value;
  }
}

/// A tree that has been divided needs the divisions and nothing that came after them.
TYPED_TEST(Minimize, OperatorsThatDoNotMatterAreSwitchedOff) {
  constexpr int kD = TypeParam::value;
  const auto is_high = [](const Scenario<kD>& scenario) {
    Bsp<kD> tree(scenario.info.config);
    std::uint32_t height = 0;
    for (const ScenarioStep<kD>& step : scenario.steps) {
      apply(step.requests, tree);
      tree.set_config(step.config);
      tree.step();
      height = std::max(height, tree.statistics().height);
    }
    return height >= 2;
  };
  const Scenario<kD> whole = this->crowd();
  ASSERT_TRUE(is_high(whole));
  const Scenario<kD> small = minimize<kD>(whole, is_high);
  EXPECT_TRUE(is_high(small));
  const std::vector<Acting> acting = acting_operators(small);
  EXPECT_LT(acting.size(), acting_operators(whole).size() / 4);
  for (const Acting& one : acting) EXPECT_FALSE(is_high(without_operators(small, {one})));
  const test::TemporaryRecording file;
  record(small, file.path());
  RecordingReader<kD> recorded(file.path());
  EXPECT_EQ(recorded.steps(), small.steps.size());
  for (std::uint32_t step = 1; step <= recorded.steps(); ++step)
    EXPECT_EQ(config_of(recorded.info(), step), small.steps[step - 1].config);
}

}  // namespace
}  // namespace kerf
