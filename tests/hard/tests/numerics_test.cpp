// M3 and N cases: what the interface and the build must not allow.

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "core/bsp/bsp.h"
#include "tests/hard/cases.h"
#include "tests/hard/feed.h"
#include "tests/hard/settings.h"
#include "tests/support/boxes.h"
#include "tests/support/checked.h"
#include "tests/support/dimensions.h"

namespace kerf::test {
namespace {

/// HARD_CASES M3: a box can only be changed by a request. What the tree shows of itself is const.
template <class Broad, int D>
concept CanBeChangedBehindItsBack = requires(Broad& broad, Box<D> box) {
  broad.tree().table.move(ObjectId{0}, box);
};
static_assert(!CanBeChangedBehindItsBack<Bsp<2>, 2>);
static_assert(!CanBeChangedBehindItsBack<Bsp<3>, 3>);
static_assert(std::is_const_v<std::remove_reference_t<decltype(std::declval<Bsp<3>&>().tree())>>);

template <class T>
class HardNumerics : public testing::Test {};
TYPED_TEST_SUITE(HardNumerics, Dimensions, DimensionNames);

/// HARD_CASES N2: leaves of every size around the widths of vectors, so that each entry is once in a full
/// vector and once in what is left over. All boxes touch their neighbours by exactly one float.
TYPED_TEST(HardNumerics, N2_LeavesOfEverySizeGiveTheirPairs) {
  constexpr int kD = TypeParam::value;
  for (std::uint32_t n = 0; n <= 67; ++n) {
    Bsp<kD> bsp;
    Checked<kD> checked(bsp);
    for (std::uint32_t k = 0; k < n; ++k) {
      const auto low = static_cast<Scalar>((k * 29) % 67);
      Box<kD> box{all<kD>(0), all<kD>(1)};
      box.min[static_cast<int>(k % 2)] = low;
      box.max[static_cast<int>(k % 2)] = low + 3;
      EXPECT_EQ(checked.insert({k}, box, k % 5 == 0 ? Mobility::fixed : Mobility::moving), Status::ok);
    }
    checked.step();
    ASSERT_FALSE(this->HasFailure()) << n << " objects";
  }
}

/// HARD_CASES N3: neither where memory lies nor what else the process has done shows in pairs or state.
TYPED_TEST(HardNumerics, N3_TheSameScriptGivesTheSameStateAnywhere) {
  constexpr int kD = TypeParam::value;
  for (const HardCase& hard_case : hard_cases()) {
    if (hard_case.id != "M9" && hard_case.id != "M4" && hard_case.id != "V4") continue;
    const Script<kD> script = make_script<kD>(hard_case, Size::test);
    Config config;
    apply(config, kEagerConfig);
    Bsp<kD> first(config);
    std::vector<std::unique_ptr<char[]>> litter;
    for (std::size_t size = 1; size < 4000; size += 37) litter.push_back(std::make_unique<char[]>(size));
    for (std::size_t k = 0; k < litter.size(); k += 2) litter[k].reset();
    Bsp<kD> second(config);
    for (const ScriptStep<kD>& step : script) {
      for (const Request<kD>& request : step.requests) {
        (void)ask<kD>(first, request, Feed::boxes);
        (void)ask<kD>(second, request, Feed::boxes);
        litter.push_back(std::make_unique<char[]>(request.object.value % 97 + 1));
      }
      first.step();
      second.step();
      ASSERT_EQ(first.state_hash(), second.state_hash()) << hard_case.id;
      ASSERT_TRUE(std::ranges::equal(first.pairs(), second.pairs())) << "in the same order";
    }
  }
}

}  // namespace
}  // namespace kerf::test
