// Worlds that most objects have left: few of many ids have an object.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "core/bsp/bsp.h"
#include "core/replay/oracle.h"
#include "core/tree/validate.h"
#include "tests/support/boxes.h"
#include "tests/support/config_of.h"
#include "tests/support/dimensions.h"
#include "tests/support/pairs.h"

namespace kerf::test {
namespace {

template <class Dim>
class FewOfMany : public testing::Test {};
TYPED_TEST_SUITE(FewOfMany, Dimensions, DimensionNames);

/// 40,000 objects of which all but 50 go. Fast ones are swept, slow ones kept.
template <int D>
class LeftWorld {
 public:
  static constexpr std::uint32_t kIds = 40'000;

  explicit LeftWorld(double speed) : speed_(speed) {
    for (std::uint32_t id = 0; id < kIds; ++id)
      EXPECT_EQ(tree_.insert({id}, draw(), Mobility::moving), Status::ok);
    tree_.step();
    for (std::uint32_t id = 0; id < kIds; ++id) {
      if (id % 800 == 0) {
        left_.push_back({id});
      } else {
        EXPECT_EQ(tree_.remove({id}), Status::ok);
      }
    }
  }
  void move_all() {
    for (const ObjectId object : left_) {
      const Box<D> box = tree_.objects().box(object);
      const Vector<D> way = random_point<D>(random_, -speed_, speed_);
      EXPECT_EQ(tree_.move(object, {box.min + way, box.max + way}), Status::ok);
    }
  }
  /// One comes, one goes and comes again elsewhere, one becomes fixed, and one has no box for a while.
  void change_some() {
    const ObjectId coming{random_.below(kIds)};
    if (tree_.insert(coming, draw(), Mobility::moving) == Status::ok) left_.push_back(coming);
    for (const Mobility mobility : {Mobility::moving, Mobility::fixed}) {
      const ObjectId object = left_[random_.below(static_cast<std::uint32_t>(left_.size()))];
      EXPECT_EQ(tree_.remove(object), Status::ok);
      EXPECT_EQ(tree_.insert(object, draw(), mobility), Status::ok);
    }
    const ObjectId lost = left_[random_.below(static_cast<std::uint32_t>(left_.size()))];
    const Box<D> box = tree_.objects().box(lost);
    Box<D> bad = box;
    bad.min[0] = std::numeric_limits<Scalar>::quiet_NaN();
    EXPECT_EQ(tree_.move(lost, bad), Status::quarantined);
    step();
    EXPECT_EQ(tree_.move(lost, box), Status::ok);
  }
  void step() {
    tree_.step();
    EXPECT_TRUE(same_pairs(tree_.pairs(), oracle_pairs(tree_.objects())));
    EXPECT_TRUE(validate(tree_.tree()).empty());
  }
  [[nodiscard]] Mode mode() const { return tree_.mode(); }

 private:
  Box<D> draw() {
    const Vector<D> at = random_point<D>(random_, 0, D == 2 ? 6 : 3);
    return {at, at + all<D>(1)};
  }

  Random random_{21};
  double speed_;
  Bsp<D> tree_{tuned_with_leaves_of(32)};
  std::vector<ObjectId> left_;
};

TYPED_TEST(FewOfMany, PairsAreThoseOfTheBoxesWhateverComesAndGoes) {
  constexpr int kD = TypeParam::value;
  for (const double speed : {0.5, 0.0005}) {
    LeftWorld<kD> world(speed);
    for (int k = 0; k < 60; ++k) {
      world.move_all();
      if (k % 3 == 0) world.change_some();
      world.step();
    }
  }
}

/// A sample of all ids would meet hardly any object, as if all stood. At first those that went are sampled.
TYPED_TEST(FewOfMany, TheirMotionsAreSeen) {
  constexpr int kD = TypeParam::value;
  for (const double speed : {0.5, 0.0005}) {
    LeftWorld<kD> world(speed);
    int kept = 0;
    for (int k = 0; k < 200; ++k) {
      world.move_all();
      world.step();
      kept += k >= 20 && world.mode() == Mode::kept ? 1 : 0;
    }
    EXPECT_TRUE(speed > 0.1 ? kept == 0 : kept > 150) << kept << " of 200 steps, speed " << speed;
  }
}

}  // namespace
}  // namespace kerf::test
