// A million hard pairs of every kind. The program kerf_property_soak tries a hundred times as many.

#include "tests/property/pair_property.h"

#include <gtest/gtest.h>

#include "tests/support/dimensions.h"

namespace kerf::test {
namespace {

template <class T>
class HardPairs : public testing::Test {};
TYPED_TEST_SUITE(HardPairs, Dimensions, DimensionNames);

TYPED_TEST(HardPairs, OverlapAlongEveryDirectionAndAreReportedOnce) {
  constexpr int kD = TypeParam::value;
  constexpr std::uint64_t kPairs = 500'000;
  const auto kinds = volume_kinds<kD>();
  std::uint64_t pairs = 0;
  for (const VolumeKind kind : kinds) {
    PairProperty<kD> property(kind, 20);
    while (property.count().pairs < kPairs / kinds.size()) property.try_tree();
    const PropertyCount& count = property.count();
    EXPECT_EQ(count.findings(), 0U) << to_string(kind) << ": " << count.missed << " missed, " << count.twice
                                    << " twice, " << count.invented << " invented, " << count.apart
                                    << " intervals apart; first: " << count.first;
    pairs += count.pairs;
  }
  EXPECT_GE(pairs, kPairs);
}

}  // namespace
}  // namespace kerf::test
