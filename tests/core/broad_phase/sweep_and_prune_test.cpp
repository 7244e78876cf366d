#include "core/broad_phase/sweep_and_prune.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace kerf {
namespace {

constexpr AxisChoice kXz{true, false, true};

Box<3> at(float x, float y) { return {{{x, y, 0}}, {{x + 1, y + 1, 1}}}; }

TEST(SweepAndPrune, LeavesOutAnAxisForCandidatesButNotForPairs) {
  SweepAndPrune<3> lists(kXz);
  ASSERT_EQ(lists.insert({0}, at(0, 0), Mobility::moving), Status::ok);
  ASSERT_EQ(lists.insert({1}, at(0.5F, 7), Mobility::moving), Status::ok);
  lists.step();
  EXPECT_EQ(lists.candidates(), 1U);
  EXPECT_EQ(lists.pairs().size(), 0U);
  ASSERT_EQ(lists.move({1}, at(1, 1)), Status::ok);
  lists.step();
  EXPECT_EQ(lists.pairs().size(), 1U) << "they touch";
}

TEST(SweepAndPrune, ForgetsACandidateWhereItsEndsSwap) {
  SweepAndPrune<3> lists;
  ASSERT_EQ(lists.insert({0}, at(0, 0), Mobility::moving), Status::ok);
  ASSERT_EQ(lists.insert({1}, at(0.5F, 0.5F), Mobility::moving), Status::ok);
  lists.step();
  EXPECT_EQ(lists.candidates(), 1U);
  ASSERT_EQ(lists.move({1}, at(2, 0.5F)), Status::ok);
  lists.step();
  EXPECT_EQ(lists.candidates(), 0U);
  ASSERT_EQ(lists.move({1}, at(-0.5F, 0.5F)), Status::ok);
  lists.step();
  EXPECT_EQ(lists.candidates(), 1U) << "it has passed through";
}

TEST(SweepAndPrune, NeedsAnAxis) {
  EXPECT_THROW(SweepAndPrune<3>({false, false, false}), std::invalid_argument);
  EXPECT_THROW(SweepAndPrune<2>({false, false, true}), std::invalid_argument) << "2D has no third";
}

}  // namespace
}  // namespace kerf
