#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "core/bsp/bsp.h"
#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"

namespace kerf::test {
namespace {

template <class T>
class LongCalls : public testing::Test {};
TYPED_TEST_SUITE(LongCalls, Dimensions, DimensionNames);

/// One thread takes a call in pieces while pairs are kept, several take it as a whole. Among the requests are
/// objects twice, far apart, unknown ones and bad boxes, which come last in the order of changes.
TYPED_TEST(LongCalls, InPiecesAreTakenLikeWholeOnes) {
  constexpr int kD = TypeParam::value;
  constexpr std::uint32_t kCount = 2000;
  Random random(31);
  kerf::Bsp<kD> alone(tuned_config());
  kerf::Bsp<kD> shared(tuned_config());
  shared.set_threads(2, Sharing::always);
  std::vector<ObjectId> objects;
  std::vector<Box<kD>> boxes;
  for (std::uint32_t id = 0; id < kCount; ++id) {
    objects.push_back({id});
    boxes.push_back(box_at<kD>(random_point<kD>(random, 0, kD == 2 ? 30 : 12), 0.5F));
    for (kerf::Bsp<kD>* const tree : {&alone, &shared})
      ASSERT_EQ(tree->insert({id}, boxes.back(), Mobility::moving), Status::ok);
  }
  for (const std::uint32_t id : {3U, 600U, 1999U, kCount + 5}) {
    objects.push_back({id});
    boxes.push_back(boxes[id % kCount]);
  }
  for (int step = 0; step < 20; ++step) {
    for (Box<kD>& box : boxes) {
      const Vector<kD> by = random_point<kD>(random, -0.01, 0.01);
      box = {box.min + by, box.max + by};
    }
    std::vector<Box<kD>> given = boxes;
    if (step > 8) given[700 + static_cast<std::size_t>(step)] = slab<kD>(1, 0);
    const Status first = step > 8 ? Status::quarantined : Status::unknown_id;
    EXPECT_EQ(alone.move_many(objects, given), first);
    EXPECT_EQ(shared.move_many(objects, given), first);
    alone.step();
    shared.step();
    ASSERT_TRUE(std::ranges::equal(alone.pairs(), shared.pairs())) << "step " << step;
    ASSERT_EQ(alone.state_hash(), shared.state_hash()) << "step " << step;
  }
  EXPECT_EQ(alone.mode(), Mode::kept);
}

}  // namespace
}  // namespace kerf::test
