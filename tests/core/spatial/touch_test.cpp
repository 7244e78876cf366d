// The definitions of what queries find, against integers, which do not round. Coordinates are small, so that
// most queries touch something exactly, or so large that floats round their differences.

#include "core/spatial/touch.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/base/random.h"
#include "tests/support/dimensions.h"

namespace kerf::test {
namespace {

using Whole = std::int64_t;

template <class Param>
class Touch : public testing::Test {
 protected:
  static constexpr int kDimension = Param::value;
  static constexpr auto kAxes = static_cast<std::size_t>(kDimension);
  using Wholes = std::array<Whole, kAxes>;

  struct WholeBox {
    Wholes min;
    Wholes max;
  };

  Wholes numbers(Whole most) {
    Wholes all;
    for (Whole& x : all) x = number(most);
    return all;
  }
  Whole number(Whole most) {
    return static_cast<Whole>(random_.below(static_cast<std::uint32_t>(2 * most + 1))) - most;
  }
  WholeBox box(Whole most) {
    WholeBox box{numbers(most), numbers(most)};
    for (std::size_t i = 0; i < kAxes; ++i)
      if (box.min[i] > box.max[i]) std::swap(box.min[i], box.max[i]);
    return box;
  }
  /// Mostly small; else as large as a float can be without rounding.
  Whole most() { return random_.below(4) == 0 ? (Whole{1} << 23) : 4; }

  static Vector<kDimension> to_floats(const Wholes& x) {
    Vector<kDimension> v;
    for (std::size_t i = 0; i < kAxes; ++i) v.value[i] = static_cast<Scalar>(x[i]);
    return v;
  }
  static Box<kDimension> to_floats(const WholeBox& box) { return {to_floats(box.min), to_floats(box.max)}; }

  /// Whether t from 0 to `max_t` exists at which moved + t * along touches the box: the fractions that bound
  /// t are compared crosswise.
  static bool meets(const WholeBox& moved, const Wholes& along, Whole max_t, const WholeBox& box) {
    struct Fraction {
      Whole over;
      Whole under;
    };
    std::vector<Fraction> from{{0, 1}};
    std::vector<Fraction> to{{max_t, 1}};
    for (std::size_t i = 0; i < kAxes; ++i) {
      const Whole up = box.min[i] - moved.max[i];
      const Whole down = box.max[i] - moved.min[i];
      if (along[i] == 0 && (up > 0 || down < 0)) return false;
      if (along[i] > 0) from.push_back({up, along[i]});
      if (along[i] > 0) to.push_back({down, along[i]});
      if (along[i] < 0) from.push_back({-down, -along[i]});
      if (along[i] < 0) to.push_back({-up, -along[i]});
    }
    for (const Fraction& a : from)
      for (const Fraction& b : to)
        if (a.over * b.under > b.over * a.under) return false;
    return true;
  }

  Random random_{1};
  std::array<int, 2> answers_{};
};
TYPED_TEST_SUITE(Touch, Dimensions, DimensionNames);

constexpr int kTrials = 40'000;

TYPED_TEST(Touch, CastsAreExact) {
  for (int trial = 0; trial < kTrials; ++trial) {
    const Whole most = this->most();
    const auto moved = trial % 2 == 0 ? this->box(most) : typename TestFixture::WholeBox{};
    const auto along = this->numbers(most);
    const Whole max_t = std::abs(this->number(4));
    const auto box = this->box(most);
    const bool expected = this->meets(moved, along, max_t, box);
    const SweptBox<TypeParam::value> swept{this->to_floats(moved), this->to_floats(along),
                                           static_cast<Scalar>(max_t)};
    ASSERT_EQ(touches(Cast(swept), this->to_floats(box)), expected) << trial;
    ++this->answers_[expected ? 1 : 0];
  }
  EXPECT_GT(this->answers_[0], kTrials / 10);
  EXPECT_GT(this->answers_[1], kTrials / 10);
}

TYPED_TEST(Touch, SegmentsAreExact) {
  for (int trial = 0; trial < kTrials; ++trial) {
    const Whole most = this->most();
    const auto from = this->numbers(most);
    const auto to = this->numbers(most);
    auto along = to;
    for (std::size_t i = 0; i < along.size(); ++i) along[i] -= from[i];
    const auto box = this->box(most);
    const Segment<TypeParam::value> segment{this->to_floats(from), this->to_floats(to)};
    ASSERT_EQ(touches(Cast(segment), this->to_floats(box)), this->meets({from, from}, along, 1, box))
        << trial;
  }
}

TYPED_TEST(Touch, SegmentsKeepWhatFloatsAndDoublesRound) {
  constexpr int kD = TypeParam::value;
  Segment<kD> segment;  // its direction has no float, and no double
  segment.from[0] = 0x1p100F;
  segment.to[0] = -1;
  const Cast<kD> cast(segment);
  Box<kD> at_end;
  at_end.min[0] = at_end.max[0] = -1;
  EXPECT_TRUE(touches(cast, at_end));
  at_end.min[0] = at_end.max[0] = std::nextafter(-1.0F, -2.0F);
  EXPECT_FALSE(touches(cast, at_end));
}

TYPED_TEST(Touch, SpheresAreExact) {
  for (int trial = 0; trial < kTrials; ++trial) {
    const Whole most = this->most();
    const auto center = this->numbers(most);
    const Whole radius = std::abs(this->number(most));
    const auto box = this->box(most);
    Whole distance = 0;
    for (std::size_t i = 0; i < center.size(); ++i) {
      const Whole apart = std::max({box.min[i] - center[i], center[i] - box.max[i], Whole{0}});
      distance += apart * apart;
    }
    const Sphere<TypeParam::value> sphere{this->to_floats(center), static_cast<Scalar>(radius)};
    ASSERT_EQ(touches(sphere, this->to_floats(box)), distance <= radius * radius) << trial;
  }
}

TYPED_TEST(Touch, FrustumsAreExact) {
  for (int trial = 0; trial < kTrials; ++trial) {
    const Whole most = this->most();
    const auto normal = this->numbers(most);
    const Whole offset = this->number(most);
    const auto box = this->box(most);
    Whole least = 0;
    for (std::size_t i = 0; i < normal.size(); ++i)
      least += std::min(normal[i] * box.min[i], normal[i] * box.max[i]);
    const Plane<TypeParam::value> plane{this->to_floats(normal), static_cast<Scalar>(offset)};
    ASSERT_EQ(touches(Frustum<TypeParam::value>{{&plane, 1}}, this->to_floats(box)), least <= offset)
        << trial;
  }
}

TYPED_TEST(Touch, AHitInsideIsAtZero) {
  constexpr int kD = TypeParam::value;
  Ray<kD> ray;
  ray.direction[0] = 1;
  Box<kD> box;
  box.min[0] = -1;
  box.max[0] = 1;
  EXPECT_EQ(entry_of(Cast<kD>(ray), box), 0);
  ray.origin[0] = -3;
  EXPECT_EQ(entry_of(Cast<kD>(ray), box), 2);
}

}  // namespace
}  // namespace kerf::test
