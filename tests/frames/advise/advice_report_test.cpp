#include "frames/advise/advice_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kerf {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

AdvisedRecording advised_of(double slowest) {
  AdvisedRecording advised;
  advised.plan.scene = "pile";
  for (const double times : {1.0, 2.0, slowest}) {
    BenchRow row;
    row.cell = {"pile", 3, 1000, 1};
    row.algorithm = "times-" + std::to_string(static_cast<int>(times));
    row.median_ns = 100 * times;
    row.p99_ns = 150 * times;
    row.round_ns = {row.median_ns};
    advised.cell.rows.push_back(row);
  }
  advised.advice = advise(advised.cell);
  return advised;
}

/// It left them out without a word.
TEST(AdvicePlot, SaysHowManyItLeavesOut) {
  const std::string some = advice_plot(advised_of(50));
  EXPECT_THAT(some, HasSubstr("1 slower than 40 times the fastest left out"));
  EXPECT_THAT(some, Not(HasSubstr("times-50")));
  const std::string all = advice_plot(advised_of(30));
  EXPECT_THAT(all, Not(HasSubstr("left out")));
  EXPECT_THAT(all, HasSubstr("times-30"));
}

}  // namespace
}  // namespace kerf
