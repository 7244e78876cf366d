#include "viz/draw/pair_density.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

View picture() {
  View view;
  view.picture_width = 1280;
  view.picture_height = 720;
  return view;
}

TEST(PairDensity, AFewLinesKeepTheirStrength) {
  PairDensity density(picture());
  density.add({400, 300}, 40);
  EXPECT_EQ(density.strength({400, 300}), 1);
  EXPECT_EQ(density.strength({1280, 720}), 1) << "also at the edge of the picture";
}

/// Whatever their number, they are together hardly darker than a few.
TEST(PairDensity, ManyLinesShareTheInkOfAFew) {
  double last = 1;
  for (const int lines : {20, 60, 180}) {
    PairDensity density(picture());
    for (int k = 0; k < lines; ++k) density.add({400, 300}, 40);
    const double strength = density.strength({400, 300});
    EXPECT_LT(strength, last) << lines;
    EXPECT_GE(strength, 0.4) << "each remains visible";
    EXPECT_EQ(density.strength({800, 300}), 1) << "those elsewhere do not count";
    last = strength;
  }
}

TEST(PairDensity, ALineThatMovesFadesALittle) {
  PairDensity density(picture());
  for (int k = 0; k < 60; ++k) density.add({400, 300}, 40);
  for (double x = 380; x < 470; x += 1)
    EXPECT_NEAR(density.strength({x, 300}), density.strength({x + 1, 300}), 0.08) << x;
}

TEST(PairDensity, WhatLiesOutsideCountsAtTheEdge) {
  PairDensity density(picture());
  for (int k = 0; k < 200; ++k) density.add({-1e9, 1e9}, 40);
  EXPECT_LT(density.strength({0, 720}), 1);
  EXPECT_EQ(density.strength({640, 360}), 1);
}

}  // namespace
}  // namespace kerf
