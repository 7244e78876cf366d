// Every broad phase of core refuses ids far beyond the number of its objects, whatever their value, and uses
// no memory for them.

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "core/broad_phase/all_pairs.h"
#include "core/broad_phase/approximate.h"
#include "core/broad_phase/brute_force.h"
#include "core/broad_phase/columns.h"
#include "core/broad_phase/loose_octree.h"
#include "core/broad_phase/sort_and_sweep.h"
#include "core/broad_phase/sweep_and_prune.h"
#include "core/bsp/bsp.h"
#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"

namespace kerf::test {
namespace {

template <class T>
class SparseIds : public testing::Test {};
TYPED_TEST_SUITE(SparseIds, Dimensions, DimensionNames);

template <int D>
std::vector<std::unique_ptr<BroadPhase<D>>> every_broad_phase() {
  std::vector<std::unique_ptr<BroadPhase<D>>> all;
  all.push_back(std::make_unique<Bsp<D>>(Config{}));
  all.push_back(std::make_unique<Bsp<D>>(tuned_config()));
  all.push_back(std::make_unique<AllPairs<D>>());
  all.push_back(std::make_unique<BruteForce<D>>());
  all.push_back(std::make_unique<Columns<D>>());
  all.push_back(std::make_unique<LooseOctree<D>>());
  all.push_back(std::make_unique<SortAndSweep<D>>());
  all.push_back(std::make_unique<SweepAndPrune<D>>());
  all.push_back(std::make_unique<Approximate<D>>(std::make_unique<AllPairs<D>>(), Approximation{}));
  return all;
}

/// Bytes that are in memory now.
std::size_t memory() {
  std::size_t all = 0;
  std::size_t resident = 0;
  std::ifstream("/proc/self/statm") >> all >> resident;
  return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

TYPED_TEST(SparseIds, AreRefusedByEveryBroadPhaseAndCostNothing) {
  constexpr int kD = TypeParam::value;
  for (const auto& broad_phase : every_broad_phase<kD>()) {
    SCOPED_TRACE(std::string(broad_phase->name()));
    ASSERT_EQ(broad_phase->insert({0}, slab<kD>(0, 2), Mobility::moving), Status::ok);
    ASSERT_EQ(broad_phase->insert({1000}, slab<kD>(1, 3), Mobility::moving), Status::ok);
    const std::size_t before = memory();
    for (const std::uint32_t id : {4'000'000'000U, 30'000'000U, UINT32_MAX - 1}) {
      EXPECT_EQ(broad_phase->insert({id}, slab<kD>(0, 2), Mobility::moving), Status::sparse_id);
      EXPECT_EQ(broad_phase->move({id}, slab<kD>(0, 2)), Status::unknown_id);
      EXPECT_EQ(broad_phase->remove({id}), Status::unknown_id);
      broad_phase->step();
      EXPECT_EQ(broad_phase->pairs().size(), 1U);
    }
    EXPECT_LT(memory(), before + (std::size_t{16} << 20U));
  }
}

TEST(ObjectTableIds, MayBeAsManyAsThereAreObjectsTimesFive) {
  ObjectTable<2> table;
  EXPECT_EQ(table.insert({kFreeIds}, slab<2>(0, 1), Mobility::moving), Status::sparse_id);
  ASSERT_EQ(table.insert({kFreeIds - 1}, slab<2>(0, 1), Mobility::moving), Status::ok);
  EXPECT_EQ(table.insert({kFreeIds + 3}, slab<2>(0, 1), Mobility::moving), Status::ok);
  EXPECT_EQ(table.insert({kFreeIds + 8}, slab<2>(0, 1), Mobility::moving), Status::sparse_id);
  ASSERT_EQ(table.remove({kFreeIds + 3}), Status::ok);
  EXPECT_EQ(table.insert({kFreeIds + 3}, slab<2>(0, 1), Mobility::moving), Status::ok)
      << "there is room for it";
}

}  // namespace
}  // namespace kerf::test
