#include "sims3d/rivals/ode_space.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/support/checked.h"

namespace kerf::test {
namespace {

constexpr Box<3> kBounds{{{-10, -10, -10}}, {{10, 10, 10}}};

class OdeSpaces : public testing::TestWithParam<OdeSpaceKind> {};

/// ODE itself takes what has no extent for nothing.
TEST_P(OdeSpaces, FlatBoxesAndPointsHavePairs) {
  OdeSpace space(GetParam(), kBounds);
  Checked<3> checked(space);
  const auto insert = [&](std::uint32_t id, const Box<3>& box, Mobility mobility) {
    EXPECT_EQ(checked.insert({id}, box, mobility), Status::ok);
  };
  insert(0, {{{-2, 0, -2}}, {{2, 0, 2}}}, Mobility::fixed);
  insert(1, {{{0, -1, 0}}, {{1, 1, 1}}}, Mobility::moving);
  insert(2, {{{1, 0, 1}}, {{1, 0, 1}}}, Mobility::moving);
  insert(3, {{{3, 3, 3}}, {{3, 3, 3}}}, Mobility::moving);
  checked.step();
  EXPECT_EQ(checked.pairs().size(), 3U);
}

std::string kind_name(const testing::TestParamInfo<OdeSpaceKind>& info) {
  std::string name(OdeSpace(info.param, kBounds).name());
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, OdeSpaces,
                         testing::Values(OdeSpaceKind::hash, OdeSpaceKind::quadtree,
                                         OdeSpaceKind::sweep_and_prune),
                         kind_name);

}  // namespace
}  // namespace kerf::test
