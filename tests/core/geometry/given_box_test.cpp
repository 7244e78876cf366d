#include "core/geometry/given_box.h"

#include <gtest/gtest.h>

#include "core/base/random.h"

namespace kerf {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

GivenBox<2> given(double min, double max) { return {{min, 0}, {max, 1}}; }

TEST(GivenBox, IsRoundedOutwardToFloats) {
  for (const double x : {0.1, -0.1, 20000000.9, -2.220446049250313e-61, 1e-40, 1e300, -1e300, 0.0, 1.0}) {
    const Box<2> box = round_outward(given(x, x));
    if (std::abs(x) < 1e38) {
      EXPECT_LE(static_cast<double>(box.min[0]), x);
      EXPECT_GE(static_cast<double>(box.max[0]), x);
    }
    EXPECT_TRUE(is_valid(box)) << x;
  }
  EXPECT_LT(round_outward(given(-2.2e-61, 1)).min[0], 0.0F);
  EXPECT_EQ(to_given(round_outward(given(0.5, 0.75))), given(0.5, 0.75)) << "floats stay as they are";
}

/// What overlaps in doubles overlaps in the floats around them, so that a tree of floats misses no pair.
TEST(GivenBox, NoOverlapIsLostByRounding) {
  Random random(3);
  for (int k = 0; k < 100'000; ++k) {
    const double at = std::ldexp(random.unit() - 0.5, static_cast<int>(random.below(60)) - 20);
    const double gap = std::ldexp(random.unit() - 0.5, static_cast<int>(random.below(40)) - 60) * at;
    const GivenBox<2> a = given(at - 1, at);
    const GivenBox<2> b = given(at + gap, at + gap + 1);
    ASSERT_LE(overlaps(a, b), overlaps(round_outward(a), round_outward(b))) << at << " " << gap;
  }
}

TEST(GivenBox, WhatCannotBePlacedStaysSo) {
  EXPECT_FALSE(is_valid(round_outward(given(3, 1))));
  EXPECT_FALSE(is_valid(round_outward(given(1.00000000001, 1)))) << "inverted by less than floats show";
  EXPECT_FALSE(is_valid(round_outward(given(1e300, 1e299))));
  EXPECT_FALSE(is_valid(round_outward(given(kNan, 1))));
  EXPECT_FALSE(is_valid(round_outward(given(0, kNan))));
}

TEST(GivenBox, GrowsByALengthOrAShare) {
  EXPECT_TRUE(overlaps(grow(given(0, 1), {0.025, 0}), grow(given(1.05, 2), {0.025, 0})));
  EXPECT_FALSE(overlaps(grow(given(0, 1), {0.024, 0}), grow(given(1.05, 2), {0.024, 0})));
  EXPECT_TRUE(overlaps(grow(given(0, 10), {0, 0.1}), given(11, 12)));
  EXPECT_FALSE(overlaps(grow(given(0, 10), {0, 0.1}), given(11.001, 12)));
  EXPECT_EQ(grow(given(0.1, 1), {}), given(0.1, 1)) << "no margin, no growth";
}

TEST(GivenBox, WithoutAnEndHasNoShareOfItsExtent) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(overlaps(grow(given(-kInfinity, 0), {0.05, 0}), grow(given(0.02, 1), {0.05, 0})));
  EXPECT_TRUE(overlaps(grow(given(-kInfinity, kInfinity), {0.05, 0}), grow(given(3, 4), {0.05, 0})));
  EXPECT_TRUE(overlaps(grow(given(-kInfinity, 0), {0, 0.1}), given(0, 1)));
  EXPECT_FALSE(overlaps(grow(given(-kInfinity, 0), {0, 0.1}), given(0.5, 1)));
}

/// 1500 + 0.05 and 1500.10009765625 - 0.05 meet in floats and not in doubles.
TEST(GivenBox, GrowsAsFarAsNumbersRound) {
  const GivenBox<2> a = given(1499, 1500);
  const Margin margin{0.05, 0};
  const GivenBox<2> b = given(1500.10009765625, 1501);
  EXPECT_TRUE(overlaps(grow<float>(a, margin), grow<float>(b, margin)));
  EXPECT_FALSE(overlaps(grow(a, margin), grow(b, margin)));
  EXPECT_FALSE(overlaps(grow<float>(a, margin), grow<float>(given(1500.1012, 1501), margin)));
  EXPECT_TRUE(overlaps(grow(a, margin), grow(given(1500.1, 1501), margin))) << "doubles round, too";
}

/// -0.1 + 0.1 is 0 in floats, and less than 0 in doubles, which hold 0.1 better.
TEST(GivenBox, TheMarginIsRoundedToo) {
  const auto tenth = static_cast<double>(0.1F);
  const Margin margin{0.1, 0};
  EXPECT_TRUE(overlaps(grow<float>(given(-1, -tenth), margin), grow<float>(given(tenth, 1), margin)));
}

/// The ways in which engines make an interval larger by a margin, or by a share of its extent.
template <class Number>
std::array<Number, 2> fattened(std::array<Number, 2> x, Number margin, int way) {
  const auto [lo, hi] = x;
  const Number half = Number(0.5);
  const Number c = (lo + hi) * half;
  const Number h = (hi - lo) * half;
  switch (way) {
    case 0:
      return {lo - margin, hi + margin};
    case 1:
      return {c - (h + margin), c + (h + margin)};
    case 2:
      return {lo - margin * (hi - lo), hi + margin * (hi - lo)};
    case 3: {
      const Number wide = h * (Number(1) + Number(2) * margin);
      return {c - wide, c + wide};
    }
    case 4: {
      const Number wide = h + Number(2) * margin * h;
      return {c - wide, c + wide};
    }
    default:
      return {lo * (Number(1) + margin) - hi * margin, hi * (Number(1) + margin) - lo * margin};
  }
}

/// Intervals that just touch in the engine's numbers: none may seem apart by more than rounding explains.
template <class Number>
void expect_excused(int way) {
  Random random(static_cast<std::uint64_t>(way) + 1);
  int touching = 0;
  for (int k = 0; k < 40'000; ++k) {
    const double share = std::array{0.1, 0.05, 0.01, 0.25, 1.0}[static_cast<std::size_t>(k % 5)];
    const auto margin = static_cast<Number>(share);
    const double size = std::ldexp(1.0, static_cast<int>(random.below(10)));
    const auto lo = static_cast<Number>(size * (random.unit() - 0.5));
    const auto hi = static_cast<Number>(lo + static_cast<Number>(random.unit()));
    const auto extent = static_cast<Number>(random.unit());
    const Number end = fattened<Number>({lo, hi}, margin, way)[1];
    Number next = way < 2 ? end + margin : end + margin * extent;
    for (int n = 0; n < 4; ++n) next = std::nextafter(next, Number(1e9));
    for (int n = 0; n < 8; ++n, next = std::nextafter(next, Number(-1e9))) {
      const Number far = next + extent;
      if (fattened<Number>({next, far}, margin, way)[0] > end) continue;
      const Margin declared = way < 2 ? Margin{share, 0} : Margin{0, share};
      const auto box = [](Number min, Number max) {
        return given(static_cast<double>(min), static_cast<double>(max));
      };
      ASSERT_TRUE(overlaps(grow<Number>(box(lo, hi), declared), grow<Number>(box(next, far), declared)))
          << "way " << way << ", " << lo << " to " << hi << " and " << next << " to " << far;
      ++touching;
      break;
    }
  }
  EXPECT_GT(touching, 20'000) << way;
}

/// An engine that keeps centres and half extents was accused: its errors have the size of its operands.
TEST(GivenBox, GrowsAsFarAsAnyWayToReckonRounds) {
  for (int way = 0; way < 6; ++way) {
    expect_excused<float>(way);
    expect_excused<double>(way);
  }
}

TEST(GivenBox, NeverGrowsByTwiceItsMargin) {
  for (const double margin : {0.05, 0.2, 0.3, 0.7, 1e-9}) {
    const GivenBox<2> grown = grow<float>(given(5000000, 5000001), {margin, 0});
    EXPECT_LE(grown.max[0] - 5000001, 2 * margin) << margin;
    EXPECT_LE(5000000 - grown.min[0], 2 * margin) << margin;
  }
}

TEST(GivenBox, JoinsAndKeepsNan) {
  EXPECT_EQ(join(given(0, 1), given(5, 6)), given(0, 6));
  EXPECT_TRUE(std::isnan(join(given(0, 1), given(kNan, 6)).min[0]));
  EXPECT_TRUE(std::isnan(join(given(kNan, 1), given(0, 6)).min[0]));
}

/// What engines of floats do with margins: beside the bounds, or by centre and half extents.
TEST(GivenBox, NoWayToAddAMarginInFloatsIsBeyondIt) {
  Random random(20261129);
  const auto within = [](float min, float max, const Margin& margin, float min_of_theirs,
                         float max_of_theirs) {
    GivenBox<2> box;
    box.min[0] = static_cast<double>(min);
    box.max[0] = static_cast<double>(max);
    const GivenBox<2> grown = grow<Scalar>(box, margin);
    return grown.min[0] <= static_cast<double>(min_of_theirs) &&
           static_cast<double>(max_of_theirs) <= grown.max[0];
  };
  for (int k = 0; k < 200'000; ++k) {
    const auto center =
        static_cast<float>(std::ldexp(random.unit() - 0.5, static_cast<int>(random.below(12))));
    const auto size =
        static_cast<float>(std::ldexp(random.unit() + 0.01, static_cast<int>(random.below(6)) - 3));
    const float min = center - size;
    const float max = center + size;
    const float share = random.below(2) == 0 ? 0.1F : 1.0F;
    const Margin by_share{0, share == 1 ? 1.0 : 0.1};
    const float c = (min + max) * 0.5F;
    const float h = (max - min) * 0.5F * (1 + 2 * share);
    ASSERT_TRUE(within(min, max, by_share, c - h, c + h)) << min << ' ' << max;
    const float m = (max - min) * share;
    ASSERT_TRUE(within(min, max, by_share, min - m, max + m)) << min << ' ' << max;
    const float half = (max - min) * 0.5F + 0.01F;
    ASSERT_TRUE(within(min, max, {0.01, 0}, c - half, c + half)) << min << ' ' << max;
    ASSERT_TRUE(within(min, max, {0.01, 0}, min - 0.01F, max + 0.01F)) << min << ' ' << max;
  }
}

}  // namespace
}  // namespace kerf
