#include "frames/support/step_range.h"

#include <gtest/gtest.h>

#include <string>

#include "frames/support/errors.h"

namespace kerf {
namespace {

TEST(StepRange, ReadsThreeForms) {
  EXPECT_EQ(parse_steps("10:20:5"), (StepRange{10, 20, 5}));
  EXPECT_EQ(parse_steps("10:20"), (StepRange{10, 20, 1}));
  EXPECT_EQ(parse_steps("20"), (StepRange{1, 20, 1}));
}

TEST(StepRange, CountsFramesUpToTheLastStep) {
  EXPECT_EQ(parse_steps("10:20:5").frames(), 3U);
  EXPECT_EQ(parse_steps("10:19:5").frames(), 2U);
  EXPECT_EQ(parse_steps("7:7").frames(), 1U);
  EXPECT_EQ(parse_steps("10:20:5").step_of(2), 20U);
  EXPECT_EQ(parse_steps("1:3:100").frames(), 1U);
}

class BadSteps : public ::testing::TestWithParam<const char*> {};

TEST_P(BadSteps, AreRefusedByName) {
  try {
    (void)parse_steps(GetParam());
    FAIL() << "accepted " << GetParam();
  } catch (const UsageError& error) {
    EXPECT_NE(std::string(error.what()).find(GetParam()), std::string::npos) << error.what();
  }
}

INSTANTIATE_TEST_SUITE_P(StepRange, BadSteps,
                         ::testing::Values("", "x", "1:", ":5", "1:2:3:4", "1:2:", "-1", "1:-5", "1.5", " 1",
                                           "0", "0:5", "20:10", "1:10:0", "10000001", "99999999999999999999",
                                           "1:10000000:1", "5:10:4294967295"));

}  // namespace
}  // namespace kerf
