#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

#include "core/base/random.h"
#include "core/world/world.h"
#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"

namespace kerf::test {
namespace {

/// All reports of a run, one after another.
template <int D>
std::vector<WorldPair> run(unsigned threads) {
  constexpr std::size_t kObjects = 3000;
  World<D> world({.threads = threads, .sharing = Sharing::always});
  Random random(4);
  std::vector<Box<D>> boxes(kObjects);
  std::vector<Handle> handles(kObjects);
  for (Box<D>& box : boxes) box = random_box<D>(random, 60, 0.7);
  const ObjectDef def;
  EXPECT_EQ(world.insert(boxes, {&def, 1}, handles), WorldStatus::ok);
  std::vector<WorldPair> reports;
  for (int step = 0; step < 12; ++step) {
    for (Box<D>& box : boxes) {
      const Vector<D> by = random_point<D>(random, -0.1, 0.1);
      box = {box.min + by, box.max + by};
    }
    EXPECT_EQ(world.move(handles, boxes), WorldStatus::ok);
    world.step();
    for (const auto& part : {world.pairs(), world.begun(), world.ended()})
      reports.insert(reports.end(), part.begin(), part.end());
  }
  return reports;
}

template <class T>
class WorldThreads : public testing::Test {};
TYPED_TEST_SUITE(WorldThreads, Dimensions, DimensionNames);

TYPED_TEST(WorldThreads, ReportsAreTheSameForAnyNumber) {
  EXPECT_EQ(run<TypeParam::value>(1), run<TypeParam::value>(2));
}

TYPED_TEST(WorldThreads, TwoWorldsRunOnTwoThreads) {
  constexpr int kD = TypeParam::value;
  const std::vector<WorldPair> alone = run<kD>(1);
  std::vector<WorldPair> first;
  std::thread other([&] { first = run<kD>(1); });
  const std::vector<WorldPair> second = run<kD>(2);
  other.join();
  EXPECT_EQ(first, alone);
  EXPECT_EQ(second, alone);
}

TYPED_TEST(WorldThreads, ManyReadAtTheSameTime) {
  constexpr int kD = TypeParam::value;
  World<kD> world;
  ObjectDef def;
  def.margin = 0.5;
  std::vector<Handle> handles;
  for (int k = 0; k < 100; ++k)
    handles.push_back(world.insert(box_at<kD>(all<kD>(static_cast<Scalar>(k)), 1), def).handle);
  world.step();
  std::atomic<std::size_t> seen = 0;
  const auto read = [&] {
    std::vector<std::uint8_t> bytes;
    for (const Handle handle : handles)
      seen +=
          world.find(handle)->margin == 0.5F && contains(*world.fat_box(handle), *world.box(handle)) ? 1 : 0;
    for (const WorldPair& pair : world.pairs()) seen += world.contains(pair.a) ? 1 : 0;
    if (world.save(bytes) == WorldStatus::ok) seen += world.tree().statistics().objects;
  };
  std::thread one(read);
  std::thread two(read);
  read();
  one.join();
  two.join();
  EXPECT_EQ(seen, 3 * (100 + world.pairs().size() + 100));
}

}  // namespace
}  // namespace kerf::test
