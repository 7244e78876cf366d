#include "sims3d/rivals/ode_space.h"

#include <gtest/gtest.h>

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
  insert(3, {{{0, 0x1p-126F, 0}}, {{1, 1, 1}}}, Mobility::moving);
  insert(4, {{{3, 3, 3}}, {{3, 3, 3}}}, Mobility::moving);
  checked.step();
  EXPECT_GE(checked.pairs().size(), 4U);
}

INSTANTIATE_TEST_SUITE_P(All, OdeSpaces,
                         testing::Values(OdeSpaceKind::hash, OdeSpaceKind::quadtree,
                                         OdeSpaceKind::sweep_and_prune),
                         [](const auto& kind) {
                           constexpr const char* kNames[] = {"hash", "quadtree", "sap"};
                           return std::string(kNames[static_cast<std::size_t>(kind.param)]);
                         });

}  // namespace
}  // namespace kerf::test
