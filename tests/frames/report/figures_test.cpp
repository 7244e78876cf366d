#include "frames/report/figures.h"

#include <gtest/gtest.h>

#include "frames/report/trade.h"

namespace kerf {
namespace {

TEST(StepTimes, AreTheLeastOfAllRoundsAndKnowTheRounds) {
  StepTimes times;
  for (const std::vector<double>& round : {std::vector<double>{10, 30}, {20, 10}, {40, 40}}) {
    times.restart();
    for (const double step : round) times.add(step);
  }
  const Times over = times.over(2);
  EXPECT_EQ(over.mean, 5);
  EXPECT_EQ(over.round_low, 7.5);
  EXPECT_EQ(over.round_high, 20);
  const Json figures = as_json(over);
  EXPECT_EQ(figures.at(low_key("mean_ns")), 7.5);
  EXPECT_EQ(figures.at(high_key("mean_ns")), 20);
}

TEST(StepTimes, OfOneRoundDoNotSpread) {
  StepTimes times;
  times.add(4);
  times.add(6);
  const Times over = times.over(1);
  EXPECT_EQ(over.round_low, 5);
  EXPECT_EQ(over.round_high, 5);
  EXPECT_EQ(StepTimes().over(1).round_high, 0);
}

TEST(StepTimes, OfAnEvenNumberOfStepsHaveTheirMedianBetweenThem) {
  StepTimes times;
  for (const double step : {1, 9, 2, 4}) times.add(step);
  EXPECT_EQ(times.over(1).median, 3);
}

TEST(Quantile, IsTheNearestNumber) {
  EXPECT_EQ(quantile({4, 1, 3, 2, 5}, 0.25), 2);
  EXPECT_EQ(quantile({4, 1, 3, 2, 5}, 0.75), 4);
  EXPECT_EQ(quantile({7}, 0.25), 7);
}

/// The first one within a twentieth of the fastest was recommended, whichever it was.
TEST(Trade, TheFastestIsRecommendedUnlessKerfAsItIsIsNearIt) {
  const Trade trade{"missed", "mean_ns", 1, "missed", "ns"};
  const auto best = [&](double kerf, double most_error = 0) {
    const Json rows{{{"setting", "kerf"}, {"missed", 0}, {"mean_ns", kerf}},
                    {{"setting", "near"}, {"missed", 0}, {"mean_ns", 104}},
                    {{"setting", "fastest"}, {"missed", 0}, {"mean_ns", 100}},
                    {{"setting", "wrong"}, {"missed", 2}, {"mean_ns", 50}}};
    return recommended_within(rows, trade, most_error)["setting"];
  };
  EXPECT_EQ(best(110), "fastest");
  EXPECT_EQ(best(104), "kerf");
  EXPECT_EQ(best(110, 3), "wrong");
  EXPECT_TRUE(best(110, -1).is_null());
}

/// The figure is the least of all rounds, step by step, and so below each of them.
TEST(Trade, PointsSpreadFromTheirFigureToTheSlowestRound) {
  const Trade trade{"missed", "mean_ns", 100, "missed, %", "ns"};
  const Json with{{"setting", "kerf:period=4"}, {"family", "every k"}, {"missed", 0.5}, {"mean_ns", 10},
                  {"mean_ns_low", 11},          {"mean_ns_high", 19}};
  Json without = with;
  without.erase("mean_ns_low");
  const Plot plot = plot_of(Json::array({with, without}), trade, "title");
  const std::vector<PlotPoint>& points = plot.series.at(0).points;
  ASSERT_TRUE(points[0].y_range);
  EXPECT_EQ(points[0].y_range->low, 10);
  EXPECT_EQ(points[0].y_range->high, 19);
  EXPECT_FALSE(points[0].x_range);
  EXPECT_EQ(points[0].name, "kerf:period=4");
  EXPECT_FALSE(points[1].y_range) << "an earlier file has none";
}

}  // namespace
}  // namespace kerf
