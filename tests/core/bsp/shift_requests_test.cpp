// What is asked of single objects in the step in which the origin is moved, while pairs are kept.
#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "core/bsp/bsp.h"
#include "core/bsp/bsp_state.h"
#include "core/replay/oracle.h"
#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"
#include "tests/support/pairs.h"

namespace kerf::test {
namespace {

/// A grid of resting boxes, each of which meets its neighbours. The first begins at zero.
template <int D>
class RestingGrid {
 public:
  RestingGrid() {
    for (std::uint32_t id = 0; id < kCount; ++id) {
      Box<D> box;
      for (std::uint32_t axis = 0, rest = id; axis < D; ++axis, rest /= kSide) {
        box.min[axis] = 4 * static_cast<Scalar>(rest % kSide);
        box.max[axis] = box.min[axis] + 5;
      }
      ids_.push_back({id});
      boxes_.push_back(box);
      EXPECT_EQ(tree.insert({id}, box, Mobility::moving), Status::ok);
    }
    for (int step = 0; step < 40; ++step) tree.step();
  }

  /// All boxes move but that of the last object, which is asked for by itself.
  void shift(Scalar by) {
    for (Box<D>& box : boxes_) box = {box.min + all<D>(by), box.max + all<D>(by)};
    EXPECT_EQ(tree.move_many(std::span(ids_).first(kCount - 1), std::span(boxes_).first(kCount - 1)),
              Status::ok);
  }
  /// The last object is a tenth as large, and meets none of the others.
  Box<D> shrunk() { return boxes_.back() = box_at(boxes_.back().min + all<D>(2.5F), 0.25F); }
  /// The last one is the first one.
  void turn_round() {
    std::swap(ids_.front(), ids_.back());
    std::swap(boxes_.front(), boxes_.back());
  }
  void check(const char* when) {
    tree.step();
    EXPECT_EQ(tree.mode(), Mode::kept) << when;
    EXPECT_TRUE(same_pairs(tree.pairs(), oracle_pairs(tree.objects()))) << when;
  }
  [[nodiscard]] ObjectId last() const { return ids_.back(); }
  [[nodiscard]] Box<D>& box() { return boxes_.back(); }

  Bsp<D> tree{tuned_config()};

 private:
  static constexpr std::uint32_t kSide = D == 2 ? 30 : 10;
  static constexpr std::uint32_t kCount = D == 2 ? kSide * kSide : kSide * kSide * kSide;

  std::vector<ObjectId> ids_;
  std::vector<Box<D>> boxes_;
};

template <class T>
class ShiftRequests : public testing::Test {
 protected:
  /// Two shifts, in which lists get slack.
  void SetUp() override {
    for (const Scalar by : {128.0F, -128.0F}) {
      grid_.shift(by);
      EXPECT_EQ(grid_.tree.move(grid_.last(), grid_.box()), Status::ok);
      grid_.check("a shift");
    }
    grid_.check("rest");
  }

  RestingGrid<T::value> grid_;
};
TYPED_TEST_SUITE(ShiftRequests, Dimensions, DimensionNames);

/// The pairs of a box that shrinks end, though it is given as a volume.
TYPED_TEST(ShiftRequests, AVolumeThatShrinksHasNoOldPair) {
  constexpr int kD = TypeParam::value;
  this->grid_.shift(128);
  const Box<kD> box = this->grid_.shrunk();
  const Vector<kD> middle = box.min + all<kD>(0.25F);
  ASSERT_EQ(this->grid_.tree.move(this->grid_.last(), make_sphere<kD>(middle, 0.25F)), Status::ok);
  this->grid_.check("the step of the shift");
  this->grid_.check("the next");
}

TYPED_TEST(ShiftRequests, ABoxThatWasEndlessMeanwhileHasNoOldPair) {
  constexpr int kD = TypeParam::value;
  constexpr Scalar kInfinity = std::numeric_limits<Scalar>::infinity();
  this->grid_.shift(128);
  ASSERT_EQ(this->grid_.tree.move(this->grid_.last(), Box<kD>{all<kD>(-kInfinity), all<kD>(kInfinity)}),
            Status::clamped);
  ASSERT_EQ(this->grid_.tree.move(this->grid_.last(), this->grid_.shrunk()), Status::ok);
  this->grid_.check("the step of the shift");
  this->grid_.check("the next");
}

/// Both zeros are one place.
TYPED_TEST(ShiftRequests, ABoxThatBeganAtMinusZeroHasNoOldPair) {
  constexpr int kD = TypeParam::value;
  this->grid_.turn_round();
  this->grid_.box().min = all<kD>(-0.0F);
  ASSERT_EQ(this->grid_.tree.move(this->grid_.last(), this->grid_.box()), Status::ok);
  this->grid_.check("before the shift");
  this->grid_.shift(128);
  ASSERT_EQ(this->grid_.tree.move(this->grid_.last(), this->grid_.shrunk()), Status::ok);
  this->grid_.check("the step of the shift");
  this->grid_.check("the next");
}

/// It did not move, though the origin did before it came.
TYPED_TEST(ShiftRequests, WhatComesAfterTheShiftIsNotRestless) {
  this->grid_.shift(128);
  ASSERT_EQ(this->grid_.tree.move(this->grid_.last(), this->grid_.box()), Status::ok);
  const ObjectId one_more{static_cast<std::uint32_t>(this->grid_.tree.objects().bound())};
  ASSERT_EQ(this->grid_.tree.insert(one_more, this->grid_.box(), Mobility::moving), Status::ok);
  this->grid_.check("the step of the shift");
  EXPECT_FALSE(this->grid_.tree.state().skins.at(one_more.index()).is_restless());
}

}  // namespace
}  // namespace kerf::test
