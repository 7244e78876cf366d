#include "viz/image/flip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

namespace kerf {
namespace {

constexpr int kWidth = 64;
constexpr int kHeight = 48;

using Rgb = std::array<int, 3>;

/// A picture given by a formula in integers, so that others can make the same.
template <class Formula>
Image picture(Formula formula) {
  Image image = make_image(kWidth, kHeight);
  auto out = image.rgba.begin();
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      for (const int value : formula(x, y)) *out++ = static_cast<std::uint8_t>(value & 255);
      ++out;
    }
  }
  return image;
}

constexpr Rgb kGround{250, 250, 247};
constexpr Rgb kLine{0, 114, 178};

Image weave(int shift) {
  return picture([=](int x, int y) {
    return Rgb{x * 5 + y * 3 + (x >= 20 && x < 30 ? shift : 0), x * y, 255 - 2 * x};
  });
}
Image ground() {
  return picture([](int, int) { return kGround; });
}
Image lines(int column) {
  return picture([=](int x, int y) { return x == column || x + y == 60 ? kLine : kGround; });
}

double at(const Channel& errors, int x, int y) { return errors.row(y)[x]; }

void expect_flip(const Image& a, const Image& b, double mean, FlipPixel worst) {
  const Channel errors = flip_errors(a, b);
  const FlipSummary summary = summarize_flip(errors);
  EXPECT_NEAR(summary.mean, mean, 2e-6);
  EXPECT_NEAR(summary.max, worst.error, 2e-5);
  EXPECT_NEAR(at(errors, worst.x, worst.y), worst.error, 2e-5);
}

// The values were computed from the paper's definition by another program: whole two-dimensional kernels in
// double precision, nothing separated and nothing left out.
TEST(Flip, AgreesWithAnotherComputation) {
  expect_flip(weave(0), weave(16), 0.0518720, {28, 36, 0.8381460});
  expect_flip(ground(), lines(31), 0.0945851, {31, 29, 0.7082053});
  expect_flip(lines(31), lines(32), 0.0319895, {32, 30, 0.3423048});
  EXPECT_NEAR(at(flip_errors(weave(0), weave(16)), 31, 10), 0.0475328, 2e-5);
  EXPECT_NEAR(at(flip_errors(ground(), lines(31)), 40, 24), 0.1584184, 2e-5);
}

// The paper scales colour differences such that the largest, from green to blue, is 1.
TEST(Flip, GreenAgainstBlueIsOne) {
  const Channel errors = flip_errors(make_image(40, 40, 0x00ff00ffU), make_image(40, 40, 0x0000ffffU));
  for (const float error : errors.values) EXPECT_NEAR(error, 1.0, 1e-5);
  const FlipSummary red =
      summarize_flip(flip_errors(make_image(40, 40, 0xff0000ffU), make_image(40, 40, 0x0000ffffU)));
  EXPECT_NEAR(red.mean, 0.9650790, 1e-5);
}

TEST(Flip, SamePicturesHaveNoErrorAndOrderDoesNotMatter) {
  const FlipSummary same = summarize_flip(flip_errors(weave(0), weave(0)));
  EXPECT_EQ(same.max, 0);
  EXPECT_TRUE(same.worst.empty());
  EXPECT_EQ(flip_errors(weave(0), weave(16)).values, flip_errors(weave(16), weave(0)).values);
}

TEST(Flip, WhatIsFarFromADifferenceIsNotLookedAtAndThatChangesNothing) {
  // One pixel differs: the errors must be those of the same pixel in a picture that is seen as a whole, since
  // its other border differs, too.
  Image a = make_image(200, 60, 0xfafaf7ff);
  Image b = a;
  std::fill_n(b.rgba.begin() + 4 * (30 * 200 + 20), 3, std::uint8_t{0});
  Image far = b;
  std::fill_n(far.rgba.begin() + 4 * (59 * 200 + 199), 3, std::uint8_t{0});
  const Channel near_errors = flip_errors(a, b);
  const Channel both_errors = flip_errors(a, far);
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 100; ++x) EXPECT_EQ(at(near_errors, x, y), at(both_errors, x, y)) << x << " " << y;
  EXPECT_GT(at(near_errors, 20, 30), 0.1);
}

TEST(Flip, TheWorstPixelsLieApart) {
  const FlipSummary summary = summarize_flip(flip_errors(ground(), lines(31)), 3);
  ASSERT_EQ(summary.worst.size(), 3U);
  EXPECT_GE(summary.worst[0].error, summary.worst[1].error);
  const auto apart = [&](std::size_t i, std::size_t j) {
    return std::max(std::abs(summary.worst[i].x - summary.worst[j].x),
                    std::abs(summary.worst[i].y - summary.worst[j].y));
  };
  EXPECT_GE(apart(0, 1), 16);
  EXPECT_GE(apart(1, 2), 16);
}

TEST(Flip, TransparencyIsSeenOverWhite) {
  const Image white = make_image(30, 30);
  EXPECT_EQ(summarize_flip(flip_errors(white, make_image(30, 30, 0xff000000U))).max, 0);
  EXPECT_GT(summarize_flip(flip_errors(white, make_image(30, 30, 0xff000080U))).max, 0.1);
}

TEST(Flip, DifferentSizesAreRefused) {
  EXPECT_THROW(flip_errors(make_image(4, 3), make_image(3, 4)), std::invalid_argument);
}

TEST(HeatMap, GoesFromBlackToLightYellow) {
  Channel errors(3, 1);
  errors.values = {0, 0.5F, 1};
  const Image image = heat_map(errors);
  EXPECT_EQ(image.rgba, (std::vector<std::uint8_t>{0, 0, 4, 255, 182, 55, 121, 255, 252, 253, 191, 255}));
}

}  // namespace
}  // namespace kerf
