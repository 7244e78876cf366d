#include "core/base/counted.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

TEST(Counted, OneOfThemIsSingular) {
  EXPECT_EQ(counted(0, "step"), "0 steps");
  EXPECT_EQ(counted(1, "step"), "1 step");
  EXPECT_EQ(counted(2, "box", "boxes"), "2 boxes");
  EXPECT_EQ(counted(1, "box that is", "boxes that are"), "1 box that is");
  EXPECT_EQ(counted_of(1, 25, "frame"), "1 of 25 frames is");
  EXPECT_EQ(counted_of(0, 1, "frame"), "0 of 1 frame are");
}

}  // namespace
}  // namespace kerf
