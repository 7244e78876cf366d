#include "frames/report/mechanics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace kerf {
namespace {

Body<2> ball_at(const Vector<2>& position, Mobility mobility = Mobility::moving) {
  const Vector<2> reach{{0.5F, 0.5F}};
  Body<2> body{Ball{0.5F}, {}, {position - reach, position + reach}, mobility};
  body.pose.position = position;
  return body;
}

TEST(Mechanics, SizesOfShapes) {
  EXPECT_NEAR(size_of<2>(Ball{2}), 4 * std::numbers::pi, 1e-9);
  EXPECT_NEAR(size_of<3>(Ball{1}), 4 * std::numbers::pi / 3, 1e-9);
  EXPECT_DOUBLE_EQ(size_of<3>(Brick<3>{{{0.5F, 1, 2}}}), 8);
  EXPECT_DOUBLE_EQ(size_of<2>(Outline{{{{0, 0}}, {{2, 0}}, {{0, 3}}}}), 3);
}

/// Half of v squared over g: a unit a step is 25 units a second.
TEST(Mechanics, EnergyIsAHeight) {
  const std::vector<Body<2>> bodies{ball_at({{0, 3}}), ball_at({{9, 100}}, Mobility::fixed)};
  EXPECT_NEAR(energy_height<2>(bodies, {}), 3, 1e-6) << "fixed bodies have none";
  const std::vector<Vector<2>> before{{{1, 3}}, {{9, 100}}};
  EXPECT_NEAR(energy_height<2>(bodies, before), 3 + 25.0 * 25 / 2 / 10, 1e-4);
}

TEST(Mechanics, PenetrationIsThatOfTheDeepestPair) {
  EXPECT_NEAR(deepest_penetration<2>(std::vector<Body<2>>{ball_at({{0, 0}}), ball_at({{0.75F, 0}}),
                                                          ball_at({{5, 0}}), ball_at({{5.9F, 0}})}),
              0.25, 1e-5);
  EXPECT_EQ(deepest_penetration<2>(std::vector<Body<2>>{ball_at({{0, 0}}), ball_at({{3, 0}})}), 0);
}

TEST(Mechanics, DistanceIsOfMovingBodiesOnly) {
  const std::vector<Body<2>> bodies{ball_at({{0, 0}}), ball_at({{0, 0}}), ball_at({{0, 0}}, Mobility::fixed)};
  const std::vector<Vector<2>> others{{{3, 4}}, {{0, 0}}, {{50, 0}}};
  EXPECT_NEAR(distance_of_runs<2>(bodies, others), std::sqrt(25.0 / 2), 1e-6);
}

}  // namespace
}  // namespace kerf
