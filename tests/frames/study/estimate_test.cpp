#include "frames/study/estimate.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

/// The quantiles of a printed table.
TEST(Estimate, QuantilesAreThoseOfTheTable) {
  EXPECT_NEAR(student_quantile(1), 12.706, 1e-3);
  EXPECT_NEAR(student_quantile(4), 2.776, 1e-3);
  EXPECT_NEAR(student_quantile(10), 2.228, 1e-3);
  EXPECT_NEAR(student_quantile(11), 2.201, 1e-3);
  EXPECT_NEAR(student_quantile(20), 2.086, 1e-3);
  EXPECT_NEAR(student_quantile(60), 2.000, 1e-3);
  EXPECT_NEAR(student_quantile(1000), 1.962, 1e-3);
}

/// Worked by hand: the mean of 1, 2, 3, 4, 5 is 3, its standard error sqrt(2.5 / 5).
TEST(Estimate, AnIntervalIsTheTextbooks) {
  const Estimate estimate = estimate_of({1, 2, 3, 4, 5});
  EXPECT_DOUBLE_EQ(estimate.mean, 3);
  EXPECT_NEAR(estimate.half, 2.77645 * 0.70710678, 1e-5);
  EXPECT_EQ(estimate.samples, 5U);
}

TEST(Estimate, OneSampleHasNoSpread) {
  const Estimate estimate = estimate_of({7});
  EXPECT_DOUBLE_EQ(estimate.mean, 7);
  EXPECT_EQ(estimate.half, 0);
  EXPECT_EQ(estimate.samples, 1U);
}

/// A hundred repeats of two seeds are two samples, not two hundred.
TEST(Estimate, RepeatsOfASeedAreNotIndependent) {
  const std::map<std::uint64_t, std::vector<double>> repeats{{1, std::vector<double>(100, 1.0)},
                                                             {2, std::vector<double>(100, 3.0)}};
  const Estimate estimate = estimate_of_seeds(repeats);
  EXPECT_DOUBLE_EQ(estimate.mean, 2);
  EXPECT_EQ(estimate.samples, 2U);
  EXPECT_NEAR(estimate.half, 12.7062, 1e-4);
}

TEST(Estimate, OfOneSeedEachRepeatCounts) { EXPECT_EQ(estimate_of_seeds({{1, {1, 2, 3}}}).samples, 3U); }

}  // namespace
}  // namespace kerf
