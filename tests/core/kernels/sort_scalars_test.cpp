#include "core/kernels/sort_scalars.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/random.h"

namespace kerf {
namespace {

TEST(SortScalars, AreThoseOfTheLibraryForEverySize) {
  Random random(7);
  for (const std::size_t size : {0, 1, 2, 31, 32, 33, 64, 100, 256, 1000, 5000}) {
    std::vector<Scalar> scalars;
    for (std::size_t k = 0; k < size; ++k)
      scalars.push_back(
          static_cast<Scalar>(random.uniform(-1, 1) * std::pow(2.0, random.uniform(-140, 127))));
    std::vector<Scalar> expected = scalars;
    std::ranges::sort(expected);
    sort_scalars(scalars);
    EXPECT_EQ(scalars, expected) << size;
  }
}

TEST(SortScalars, ManyEqualOnesAndTheGreatest) {
  constexpr Scalar kMost = std::numeric_limits<Scalar>::max();
  std::vector<Scalar> scalars;
  for (int k = 0; k < 300; ++k) scalars.push_back(k % 3 == 0 ? kMost : k % 3 == 1 ? -kMost : 1.0F);
  sort_scalars(scalars);
  EXPECT_EQ(std::ranges::count(std::span(scalars).first(100), -kMost), 100);
  EXPECT_EQ(std::ranges::count(std::span(scalars).last(100), kMost), 100);
}

/// Such are the ends of objects that lie on one another.
TEST(SortScalars, ManyEqualOnesAndOthersNextToThem) {
  Random random(20261129);
  for (int round = 0; round < 500; ++round) {
    std::vector<Scalar> scalars(50 * (1 + random.below(5)), 0.5F);
    for (int k = 0; k < 6; ++k)
      scalars.push_back(0.5F + static_cast<Scalar>(random.below(9)) * 0x1p-24F - 0x1p-22F);
    while (scalars.size() < 300) scalars.push_back(static_cast<Scalar>(random.uniform(-1, 1)));
    for (std::size_t k = scalars.size() - 1; k > 0; --k)
      std::swap(scalars[k], scalars[random.below(static_cast<std::uint32_t>(k + 1))]);
    std::vector<Scalar> expected = scalars;
    std::ranges::sort(expected);
    sort_scalars(scalars);
    ASSERT_EQ(scalars, expected) << round;
  }
}

TEST(SortScalars, ZerosHaveOneSign) {
  for (const int size : {3, 300}) {
    std::vector<Scalar> scalars;
    for (int k = 0; k < size; ++k) scalars.push_back(k % 2 == 0 ? 0.0F : -0.0F);
    sort_scalars(scalars);
    for (const Scalar zero : scalars) EXPECT_FALSE(std::signbit(zero)) << size;
  }
}

}  // namespace
}  // namespace kerf
