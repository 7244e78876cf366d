#include "sims3d/scenes/hills.h"

#include <gmock/gmock.h>

#include <cmath>

namespace kerf {
namespace {

TEST(Hills, NeighbouringTilesMeetButDoNotTouch) {
  const Hills hills(32, Random(5));
  const Surface left = hills.tile(-4, 8, 4);
  const Surface right = hills.tile(0, 8, 4);
  for (std::size_t k = 0; k < 5; ++k) {
    const Vector<3> at_left = left.vertices[5 * k + 4] + Vector<3>{{-2, 0, 10}};
    const Vector<3> at_right = right.vertices[5 * k] + Vector<3>{{2, 0, 10}};
    EXPECT_LT(at_left[0], at_right[0]);
    EXPECT_LT(at_right[0] - at_left[0], 0.005F);
    EXPECT_EQ(at_left[1], at_right[1]);
    EXPECT_EQ(at_left[2], at_right[2]);
  }
}

TEST(Hills, TrianglesAreCounterClockwiseFromAbove) {
  const Surface tile = Hills(32, Random(5)).tile(-4, 8, 4);
  ASSERT_EQ(tile.triangles.size(), 32U);
  for (const auto& [a, b, c] : tile.triangles) {
    const Vector<3> u = tile.vertices[b] - tile.vertices[a];
    const Vector<3> v = tile.vertices[c] - tile.vertices[a];
    EXPECT_GT(u[2] * v[0] - u[0] * v[2], 0);
  }
}

TEST(Hills, TheRimClosesTheSquare) {
  const Hills hills(32, Random(5));
  for (int x = -32; x <= 32; ++x) {
    EXPECT_DOUBLE_EQ(hills.height(x, 32), 9);
    EXPECT_DOUBLE_EQ(hills.height(-32, x), 9);
    if (std::abs(x) < 28) {
      EXPECT_GT(hills.height(x, 32), hills.height(x, 31) + 1) << "the wall is not steep at " << x;
    }
  }
}

TEST(Hills, ThereAreHillsAndHollows) {
  const Hills hills(32, Random(5));
  double top = 0;
  double bottom = 0;
  for (int x = -24; x <= 24; ++x) {
    for (int z = -24; z <= 24; ++z) {
      top = std::max(top, hills.height(x, z));
      bottom = std::min(bottom, hills.height(x, z));
    }
  }
  EXPECT_GT(top, 1);
  EXPECT_LT(bottom, -1);
}

TEST(Hills, SeedsAreLandscapes) {
  const auto height = [](std::uint64_t seed) { return Hills(32, Random(seed)).height(3, 4); };
  EXPECT_EQ(height(1), height(1));
  EXPECT_NE(height(1), height(2));
}

}  // namespace
}  // namespace kerf
