#include "sims3d/rivals/ode_space.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
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

/// The search alone takes longer where every object is compared with all, the building where none is.
TEST(OdeHashSpace, ItsTablesTimeIsApartFromTheSearch) {
  constexpr std::uint32_t kObjects = 1500;
  const auto share_of_table = [](Scalar spacing) {
    OdeSpace space(OdeSpaceKind::hash, kBounds);
    space.separate_times();
    Checked<3> checked(space);
    for (std::uint32_t k = 0; k < kObjects; ++k) {
      const Scalar x = spacing * static_cast<Scalar>(k);
      static_cast<void>(checked.insert({k}, {{{x, 0, 0}}, {{x + 0.4F, 0.4F, 0.4F}}}, Mobility::moving));
    }
    checked.step();
    const auto start = std::chrono::steady_clock::now();
    space.step();
    const double whole = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    EXPECT_GT(space.arrange_seconds(), 0);
    EXPECT_LT(space.arrange_seconds(), whole);
    return space.arrange_seconds() / whole;
  };
  // Others may have the processor while one of the two goes on, but not each time.
  double crowded = 1;
  double sparse = 0;
  for (int tries = 0; tries < 60 && !(crowded < 0.3 && sparse > 2 * crowded); ++tries) {
    crowded = share_of_table(1e-5F);
    sparse = share_of_table(2);
  }
  EXPECT_LT(crowded, 0.3);
  EXPECT_GT(sparse, 2 * crowded);
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
