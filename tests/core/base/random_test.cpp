#include "core/base/random.h"

#include <gtest/gtest.h>

namespace kerf::test {
namespace {

// The numbers of the authors' own splitmix64.c for this seed.
TEST(RandomNumbers, AreThoseOfSplitMix64) {
  Random random(1234567);
  EXPECT_EQ(random.bits(), 6457827717110365317U);
  EXPECT_EQ(random.bits(), 3203168211198807973U);
  EXPECT_EQ(random.bits(), 9817491932198370423U);
  EXPECT_EQ(random.bits(), 4593380528125082431U);
}

TEST(RandomNumbers, StayWithinTheirBounds) {
  Random random(1);
  double sum = 0;
  for (int i = 0; i < 100'000; ++i) {
    const double x = random.unit();
    ASSERT_GE(x, 0);
    ASSERT_LT(x, 1);
    sum += x;
    const double y = random.uniform(-3, 5);
    ASSERT_GE(y, -3);
    ASSERT_LT(y, 5);
    ASSERT_LT(random.below(7), 7U);
  }
  EXPECT_NEAR(sum / 100'000, 0.5, 0.01);
  EXPECT_EQ(random.below(0), 0U);
  EXPECT_EQ(random.below(1), 0U);
}

TEST(RandomNumbers, BelowReachesEveryNumber) {
  Random random(2);
  int seen[5] = {};
  for (int i = 0; i < 5000; ++i) ++seen[random.below(5)];
  for (const int count : seen) EXPECT_NEAR(count, 1000, 150);
}

}  // namespace
}  // namespace kerf::test
