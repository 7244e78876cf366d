#include "core/broad_phase/axis_cells.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace kerf::test {
namespace {

constexpr Scalar kMax = std::numeric_limits<Scalar>::max();
constexpr Scalar kDenormal = std::numeric_limits<Scalar>::denorm_min();

TEST(AxisCells, EachHasItsPartOfTheLength) {
  const AxisCells cells(-2, 6, 4);
  EXPECT_EQ(cells.count(), 4U);
  EXPECT_EQ(cells.cell(-2), 0U);
  EXPECT_EQ(cells.cell(-0.25F), 0U);
  EXPECT_EQ(cells.cell(0.25F), 1U);
  EXPECT_EQ(cells.cell(5.75F), 3U);
}

TEST(AxisCells, WhatLiesBeyondBelongsToTheEnds) {
  const AxisCells cells(-2, 6, 4);
  EXPECT_EQ(cells.cell(-kMax), 0U);
  EXPECT_EQ(cells.cell(6), 3U);
  EXPECT_EQ(cells.cell(kMax), 3U);
}

TEST(AxisCells, GrowWithTheCoordinate) {
  const AxisCells cells(1e7F, 1e7F + 8, 7);
  std::uint32_t before = 0;
  for (Scalar x = 1e7F - 4; x < 1e7F + 12; x = std::nextafter(x, kMax)) {
    EXPECT_GE(cells.cell(x), before);
    before = cells.cell(x);
  }
  EXPECT_EQ(before, 6U);
}

/// A scale beyond the largest float would make of zero no number.
TEST(AxisCells, AThinSceneHasOne) {
  for (const Scalar high : {0.0F, kDenormal, 100 * kDenormal, -1.0F}) {
    const AxisCells cells(0, high, 1000);
    EXPECT_EQ(cells.count(), 1U);
    EXPECT_EQ(cells.cell(0), 0U);
    EXPECT_EQ(cells.cell(kMax), 0U);
  }
}

TEST(AxisCells, SpanAllFloats) {
  const AxisCells cells(-kMax, kMax, 1000);
  EXPECT_EQ(cells.cell(-kMax), 0U);
  EXPECT_EQ(cells.cell(kMax), 999U);
  EXPECT_NEAR(cells.cell(0), 500U, 1U);
}

}  // namespace
}  // namespace kerf::test
