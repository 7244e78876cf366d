#include "frames/report/meetings.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

const Pair kFirst{{0}, {1}};
const Pair kSecond{{0}, {2}};
const Pair kThird{{3}, {4}};

void add(Meetings& meetings, const std::vector<Pair>& truth, const std::vector<Pair>& reported) {
  meetings.add(truth, reported);
}

TEST(Meetings, WhatIsReportedAtOnceHasNoLag) {
  Meetings meetings;
  add(meetings, {}, {});
  add(meetings, {kFirst}, {kFirst});
  const Json figures = meetings.figures();
  EXPECT_EQ(figures["meetings"], 1);
  EXPECT_EQ(figures["lag_max"], 0);
  EXPECT_EQ(figures["never_share"], 0);
}

TEST(Meetings, LagIsTheStepsUntilThePairIsReported) {
  Meetings meetings;
  add(meetings, {}, {});
  add(meetings, {kFirst}, {});
  add(meetings, {kFirst, kSecond}, {});
  add(meetings, {kFirst, kSecond}, {kFirst, kThird});
  add(meetings, {kFirst, kSecond}, {kFirst, kSecond});
  const Json figures = meetings.figures();
  EXPECT_EQ(figures["meetings"], 2);
  EXPECT_DOUBLE_EQ(figures["lag_mean"], 2);
  EXPECT_EQ(figures["never_share"], 0);
}

TEST(Meetings, WhatIsNeverReportedCountsWithAllItsSteps) {
  Meetings meetings;
  add(meetings, {}, {});
  for (int step = 0; step < 3; ++step) add(meetings, {kFirst}, {});
  add(meetings, {}, {kFirst});
  const Json figures = meetings.figures();
  EXPECT_EQ(figures["meetings"], 1);
  EXPECT_DOUBLE_EQ(figures["lag_mean"], 3);
  EXPECT_DOUBLE_EQ(figures["never_share"], 1);
}

/// They were left out, and settings that report the least had the fewest meetings and short lags.
TEST(Meetings, WhatIsUnreportedAtTheEndCountsWithItsStepsUpToThere) {
  Meetings meetings;
  add(meetings, {}, {});
  add(meetings, {kFirst}, {});
  for (int step = 0; step < 3; ++step) add(meetings, {kFirst, kSecond}, {kSecond});
  const Json figures = meetings.figures();
  EXPECT_EQ(figures["meetings"], 2);
  EXPECT_EQ(figures["lag_max"], 4);
  EXPECT_DOUBLE_EQ(figures["lag_mean"], 2);
  EXPECT_DOUBLE_EQ(figures["never_share"], 0.5);
  EXPECT_EQ(meetings.figures(), figures) << "asking ends nothing";
  add(meetings, {kFirst, kSecond}, {kFirst, kSecond});
  EXPECT_EQ(meetings.figures()["never_share"], 0);
}

TEST(Meetings, ASecondMeetingOfTheSameTwoCountsAnew) {
  Meetings meetings;
  add(meetings, {}, {});
  add(meetings, {kFirst}, {kFirst});
  add(meetings, {}, {});
  add(meetings, {kFirst}, {});
  add(meetings, {kFirst}, {kFirst});
  EXPECT_EQ(meetings.figures()["meetings"], 2);
  EXPECT_EQ(meetings.figures()["lag_max"], 1);
}

TEST(Meetings, WhatIsThereFromTheBeginningDoesNotCount) {
  Meetings meetings;
  add(meetings, {kFirst}, {});
  add(meetings, {kFirst}, {kFirst});
  EXPECT_EQ(meetings.figures()["meetings"], 0);
}

}  // namespace
}  // namespace kerf
