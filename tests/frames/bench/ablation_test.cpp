#include "frames/bench/ablation.h"

#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "frames/catalog/algorithm.h"

namespace kerf {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

BenchRow row_of(const std::string& scene, const std::string& algorithm, std::vector<double> rounds) {
  BenchRow row;
  row.cell = {scene, 3, 1000, 1};
  row.algorithm = algorithm;
  row.round_ns = std::move(rounds);
  return row;
}

TEST(Ablation, ComparesRoundByRoundWithTheBaseOfTheSameCell) {
  const std::vector<BenchRow> rows{
      row_of("falling", "floor", {1, 1, 1}),          row_of("falling", "kerf", {10, 20, 10}),
      row_of("falling", "kerf:skin=0", {15, 22, 9}),  row_of("settled", "kerf", {10, 10, 10}),
      row_of("settled", "kerf:skin=0", {40, 30, 20}), row_of("settled", "kerf-paper:skin=0", {9, 9, 9})};
  const std::vector<Earning> found = earnings(rows, "kerf");
  ASSERT_THAT(found, SizeIs(2));
  EXPECT_EQ(found[0].cell.scene, "falling");
  EXPECT_NEAR(found[0].median, 0.1, 1e-12);
  EXPECT_NEAR(found[0].least, -0.1, 1e-12);
  EXPECT_NEAR(found[0].most, 0.5, 1e-12);
  EXPECT_NEAR(found[1].median, 2, 1e-12);
  const std::vector<Earning> best = best_earnings(found);
  ASSERT_THAT(best, SizeIs(1));
  EXPECT_EQ(best[0].cell.scene, "settled");
  EXPECT_THAT(ablation_table(found), HasSubstr("200.0%"));
}

TEST(Ablation, SaysNothingOfAVariantWithoutABaseOrWithoutACompleteRound) {
  EXPECT_THAT(earnings({row_of("falling", "kerf:skin=0", {1})}, "kerf"), IsEmpty());
  EXPECT_THAT(earnings({row_of("falling", "kerf", {}), row_of("falling", "kerf:skin=0", {1})}, "kerf"),
              IsEmpty());
  BenchRow other = row_of("falling", "kerf", {1});
  other.cell.objects = 2000;
  EXPECT_THAT(earnings({other, row_of("falling", "kerf:skin=0", {1})}, "kerf"), IsEmpty());
}

TEST(Ablation, EveryPolicyCanBeSwitchedOff) {
  const std::vector<std::string> names = ablation_algorithms();
  ASSERT_THAT(names, SizeIs(ablated_policies().size() + 1));
  for (const std::string& name : names) {
    EXPECT_NO_THROW(check_algorithm(name)) << name;
    EXPECT_TRUE(find_algorithm<2>(name) && find_algorithm<3>(name)) << name;
  }
}

}  // namespace
}  // namespace kerf
