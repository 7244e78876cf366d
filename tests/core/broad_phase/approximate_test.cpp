#include "core/broad_phase/approximate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "core/broad_phase/brute_force.h"
#include "core/bsp/bsp.h"
#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"
#include "tests/support/moving_boxes.h"
#include "tests/support/pairs.h"

namespace kerf::test {
namespace {

/// Counts its calls.
template <int D>
class Counted final : public BroadPhase<D> {
 public:
  [[nodiscard]] std::string_view name() const override { return "counted"; }
  Status insert(ObjectId object, const Box<D>& box, Mobility mobility) override {
    return inner_.insert(object, box, mobility);
  }
  Status move(ObjectId object, const Box<D>& box) override {
    ++moves;
    return inner_.move(object, box);
  }
  Status remove(ObjectId object) override { return inner_.remove(object); }
  void step() override {
    ++steps;
    inner_.step();
  }
  [[nodiscard]] std::span<const Pair> pairs() const override { return inner_.pairs(); }

  int moves = 0;
  int steps = 0;

 private:
  BruteForce<D> inner_;
};

struct Errors {
  std::size_t missed = 0;
  std::size_t extra = 0;
};

template <class T>
class ApproximateTest : public testing::Test {
 protected:
  static constexpr int kDimension = T::value;
  static constexpr double kWorld = kDimension == 2 ? 30 : 10;

  static std::unique_ptr<Approximate<kDimension>> make(const Approximation& how) {
    return std::make_unique<Approximate<kDimension>>(std::make_unique<Bsp<kDimension>>(), how);
  }

  /// A crowd that walks by up to `distance` a step, and what was wrong in all steps.
  static Errors walk(const Approximation& how, double distance, int steps = 24) {
    const auto subject = make(how);
    BruteForce<kDimension> oracle;
    MovingBoxes<kDimension> seen(*subject, kWorld, 0.7, 5);
    MovingBoxes<kDimension> truth(oracle, kWorld, 0.7, 5);
    seen.add(300, 6);
    truth.add(300, 6);
    Errors errors;
    for (int step = 0; step < steps; ++step) {
      seen.walk(distance);
      truth.walk(distance);
      subject->step();
      oracle.step();
      count(sorted(subject->pairs()), sorted(oracle.pairs()), errors);
    }
    return errors;
  }

 private:
  static void count(const std::vector<Pair>& found, const std::vector<Pair>& truth, Errors& errors) {
    std::vector<Pair> rest;
    std::set_difference(truth.begin(), truth.end(), found.begin(), found.end(), std::back_inserter(rest));
    errors.missed += rest.size();
    rest.clear();
    std::set_difference(found.begin(), found.end(), truth.begin(), truth.end(), std::back_inserter(rest));
    errors.extra += rest.size();
  }
};

TYPED_TEST_SUITE(ApproximateTest, Dimensions, DimensionNames);

TYPED_TEST(ApproximateTest, WithoutSettingsIsExact) {
  const Errors errors = this->walk({}, 0.3);
  EXPECT_EQ(errors.missed + errors.extra, 0U);
}

TYPED_TEST(ApproximateTest, APeriodMissesAndInvents) {
  const Errors errors = this->walk({.period = 4}, 0.3);
  EXPECT_GT(errors.missed, 0U);
  EXPECT_GT(errors.extra, 0U);
}

/// Three steps of up to 0.1 between placements.
TYPED_TEST(ApproximateTest, AMarginOfTheMotionMissesNothing) {
  EXPECT_GT(this->walk({.period = 4, .margin = 0.05F}, 0.1).missed, 0U);
  const Errors errors = this->walk({.period = 4, .margin = 0.301F}, 0.1);
  EXPECT_EQ(errors.missed, 0U);
  EXPECT_GT(errors.extra, 0U);
}

TYPED_TEST(ApproximateTest, AFilteredMarginIsExact) {
  const Errors errors = this->walk({.period = 4, .margin = 0.301F, .filter = true}, 0.1);
  EXPECT_EQ(errors.missed + errors.extra, 0U);
}

TYPED_TEST(ApproximateTest, AGridInventsAndMissesNothing) {
  const Errors errors = this->walk({.grid = 0.4F}, 0.2);
  EXPECT_EQ(errors.missed, 0U);
  EXPECT_GT(errors.extra, 0U);
}

TYPED_TEST(ApproximateTest, AGridThatShrinksMisses) {
  EXPECT_GT(this->walk({.grid = 0.1F, .shrink = true}, 0.2).missed, 0U);
}

TYPED_TEST(ApproximateTest, PlacesInEveryKthStepOnly) {
  constexpr int kD = TestFixture::kDimension;
  auto inner = std::make_unique<Counted<kD>>();
  const Counted<kD>& counted = *inner;
  Approximate<kD> subject(std::move(inner), {.period = 3});
  ASSERT_EQ(subject.insert({0}, slab<kD>(0, 1), Mobility::moving), Status::ok);
  for (int step = 0; step < 7; ++step) {
    ASSERT_EQ(subject.move({0}, slab<kD>(0, static_cast<Scalar>(2 + step))), Status::ok);
    subject.step();
  }
  EXPECT_EQ(counted.steps, 3) << "in steps 0, 3 and 6";
  EXPECT_EQ(counted.moves, 3);
}

TYPED_TEST(ApproximateTest, WhatStaysInItsCellsIsNotMoved) {
  constexpr int kD = TestFixture::kDimension;
  auto inner = std::make_unique<Counted<kD>>();
  const Counted<kD>& counted = *inner;
  Approximate<kD> subject(std::move(inner), {.grid = 0.5F});
  ASSERT_EQ(subject.insert({0}, slab<kD>(0, 1), Mobility::moving), Status::ok);
  for (const Scalar x : {0.1F, 0.2F, 0.3F}) {
    ASSERT_EQ(subject.move({0}, slab<kD>(x, x + 1)), Status::ok);
    subject.step();
  }
  EXPECT_EQ(counted.moves, 1) << "0.3 is nearer to 0.5";
}

TYPED_TEST(ApproximateTest, RemovalsAndQuarantinesAreNeverLate) {
  constexpr int kD = TestFixture::kDimension;
  const auto subject = this->make({.period = 100});
  for (std::uint32_t id = 0; id < 3; ++id)
    ASSERT_EQ(subject->insert({id}, slab<kD>(0, 1), Mobility::moving), Status::ok);
  subject->step();
  EXPECT_EQ(subject->pairs().size(), 3U);
  ASSERT_EQ(subject->remove({1}), Status::ok);
  subject->step();
  ASSERT_EQ(subject->pairs().size(), 1U);
  EXPECT_EQ(subject->pairs()[0], (Pair{{0}, {2}}));
  const Scalar nan = std::numeric_limits<Scalar>::quiet_NaN();
  EXPECT_EQ(subject->move({2}, slab<kD>(nan, 1)), Status::quarantined);
  subject->step();
  EXPECT_TRUE(subject->pairs().empty());
}

TYPED_TEST(ApproximateTest, AnswersBadRequestsAsOthersDo) {
  constexpr int kD = TestFixture::kDimension;
  const auto subject = this->make({.period = 5, .grid = 0.1F});
  const Scalar infinity = std::numeric_limits<Scalar>::infinity();
  EXPECT_EQ(subject->insert({7}, slab<kD>(0, infinity), Mobility::moving), Status::clamped);
  EXPECT_EQ(subject->insert({7}, slab<kD>(0, 1), Mobility::moving), Status::duplicate_id);
  EXPECT_EQ(subject->move({8}, slab<kD>(0, 1)), Status::unknown_id);
  EXPECT_EQ(subject->remove({8}), Status::unknown_id);
  EXPECT_EQ(subject->insert({9}, slab<kD>(2, 1), Mobility::moving), Status::quarantined);
  subject->step();
  EXPECT_TRUE(subject->pairs().empty());
}

TEST(Approximation, TextAndBack) {
  Approximation how;
  apply(how, "period=4,margin=0.25,filter=1,grid=0.5,shrink=1");
  EXPECT_EQ(how, (Approximation{4, 0.25F, true, 0.5F, true}));
  EXPECT_EQ(to_string(how), "period=4,margin=0.25,filter=1,grid=0.5,shrink=1");
  EXPECT_EQ(to_string(Approximation{}), "");
}

TEST(Approximation, MistakesAreNamedAndChangeNothing) {
  Approximation how;
  for (const char* text : {"period=0", "period=1.5", "margin=-1", "margin=nan", "grid=x", "filter=2",
                           "skin=1", "shrink=1", "period", "period=2,grid=-1"}) {
    EXPECT_THROW(apply(how, text), std::invalid_argument) << text;
    EXPECT_EQ(how, Approximation{}) << text;
  }
}

}  // namespace
}  // namespace kerf::test
