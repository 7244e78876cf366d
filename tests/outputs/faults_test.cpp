#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/outputs/walk.h"

namespace kerf::faults {
namespace {

class Faults : public ::testing::TestWithParam<Scenario> {};

/// A few points of each command; `./run faults` tries hundreds.
TEST_P(Faults, NothingIsLostAndNothingIsHalf) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer's library must be loaded first";
#endif
  constexpr std::uint64_t kPoints = 3;
  const WalkResult result = walk(GetParam(), kPoints);
  EXPECT_GT(result.calls, 3U);
  EXPECT_THAT(result.findings, ::testing::IsEmpty());
  EXPECT_LT(result.unharmed, result.errors + result.full + result.kills) << "no fault was noticed";
}

std::string name_of(const ::testing::TestParamInfo<Scenario>& scenario) {
  std::string name = scenario.param.name;
  std::erase_if(name, [](char c) { return c == ' ' || c == '-'; });
  return name;
}

INSTANTIATE_TEST_SUITE_P(Commands, Faults, ::testing::ValuesIn(scenarios()), name_of);

}  // namespace
}  // namespace kerf::faults
