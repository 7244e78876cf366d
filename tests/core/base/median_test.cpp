#include "core/base/median.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

/// Of an even number it was here the lower one in the middle, and there the upper one.
TEST(Median, IsTheMeanOfTheMiddleTwo) {
  EXPECT_EQ(median({}), 0);
  EXPECT_EQ(median({7}), 7);
  EXPECT_EQ(median({9, 1, 4}), 4);
  EXPECT_EQ(median({8, 2}), 5);
  EXPECT_EQ(median({8, 1, 2, 9}), 5);
}

}  // namespace
}  // namespace kerf
