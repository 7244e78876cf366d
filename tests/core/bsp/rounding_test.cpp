// The caller's rounding mode: pairs are those of the boxes in each, also where boxes touch.
#include <gtest/gtest.h>

#include <array>
#include <cfenv>
#include <cmath>
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

/// On a grid of tenths, so that many touch: half of them points, half large.
template <int D>
std::vector<Box<D>> touching_boxes(Random& random) {
  std::vector<Box<D>> boxes(600);
  for (std::size_t k = 0; k < boxes.size(); ++k)
    for (int axis = 0; axis < D; ++axis) {
      const double low = static_cast<double>(random.below(200)) / 10;
      boxes[k].min[axis] = static_cast<Scalar>(low);
      boxes[k].max[axis] = static_cast<Scalar>(k % 2 == 0 ? low : low + 0.1 * random.below(20));
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
