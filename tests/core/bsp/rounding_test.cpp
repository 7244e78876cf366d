// The caller's rounding mode: pairs are those of the boxes in each, also where boxes touch.
#include <gtest/gtest.h>

#include <cfenv>
#include <vector>

#include "core/bsp/bsp.h"
#include "core/replay/oracle.h"
#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"
#include "tests/support/pairs.h"

namespace kerf::test {
namespace {

/// While it lives, the caller rounds that way.
class Rounding {
 public:
  explicit Rounding(int mode) { std::fesetround(mode); }
  ~Rounding() { std::fesetround(FE_TONEAREST); }
  Rounding(const Rounding&) = delete;
  Rounding& operator=(const Rounding&) = delete;
};

/// Pairs of boxes that touch on the first axis, within some units in the last place of where a byte begins:
/// the two first boxes, points, make a byte a tenth long.
template <int D>
std::vector<Box<D>> touching_boxes(Random& random) {
  std::vector<Box<D>> boxes{box_at<D>(all<D>(-0.3F), 0), box_at<D>(all<D>(25.2F), 0)};
  for (int pair = 0; pair < 300; ++pair) {
    const double ulps = static_cast<double>(random.below(9)) - 4;
    const auto touch = static_cast<Scalar>(0.1 * random.below(250) * (1 + ulps * 0x1p-23));
    Box<D> box = box_at<D>(random_point<D>(random, 0, 25), 0.5F);
    box.max[0] = touch;
    box.min[0] = touch - 1;
    boxes.push_back(box);
    box.min[0] = touch;
    box.max[0] = touch + 1;
    boxes.push_back(box);
  }
  return boxes;
}

template <class T>
class RoundingModes : public testing::Test {};
TYPED_TEST_SUITE(RoundingModes, Dimensions, DimensionNames);

TYPED_TEST(RoundingModes, PairsAreThoseOfTheBoxes) {
  constexpr int kD = TypeParam::value;
  for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    for (const unsigned threads : {1U, 3U}) {
      Random random(3);
      Bsp<kD> tree(tuned_config());
      tree.set_threads(threads, Sharing::always);
      std::vector<ObjectId> ids;
      const Rounding rounding(mode);
      for (int step = 0; step < 20; ++step) {
        const std::vector<Box<kD>> boxes = touching_boxes<kD>(random);
        for (std::uint32_t id = 0; step == 0 && id < boxes.size(); ++id) {
          ids.push_back({id});
          ASSERT_EQ(tree.insert({id}, boxes[id], Mobility::moving), Status::ok);
        }
        ASSERT_EQ(tree.move_many(ids, boxes), Status::ok);
        tree.step();
        ASSERT_EQ(std::fegetround(), mode) << "the caller's mode is its own";
        ASSERT_TRUE(same_pairs(tree.pairs(), oracle_pairs(tree.objects()))) << mode << ", step " << step;
      }
    }
  }
}

}  // namespace
}  // namespace kerf::test
