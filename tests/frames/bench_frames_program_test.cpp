#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/frames/program.h"

namespace kerf {
namespace {

using ::testing::HasSubstr;

/// The time of three small frames vanishes beside that of starting up, which is measured alone and taken off.
TEST(BenchFramesProgram, TooFewFramesAreRefused) {
  const testing::Outcome outcome =
      testing::run_kerf({"bench-frames", "--sizes", "320x200", "--boxes", "100", "--frames", "3"});
  EXPECT_EQ(outcome.exit, 2);
  EXPECT_THAT(outcome.err, HasSubstr("3 frames of 320x200 with 100 boxes: too little to measure"));
  EXPECT_THAT(outcome.err, HasSubstr("--frames"));
  EXPECT_EQ(std::ranges::count(outcome.out, '\n'), 1) << outcome.out;  // the heading alone
}

}  // namespace
}  // namespace kerf
