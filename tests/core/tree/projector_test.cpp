#include "core/tree/projector.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace kerf::test {
namespace {

Config with(std::uint32_t directions, std::uint64_t seed) {
  Config config;
  config.directions = directions;
  config.seed = seed;
  return config;
}

TEST(MakeProjector, TreesOfOneConfigurationShareIt) {
  const auto first = make_projector<3>(with(32, 1), VolumeKind::box);
  EXPECT_EQ(make_projector<3>(with(32, 1), VolumeKind::box), first);
  for (std::uint64_t seed = 2; seed < 20; ++seed) make_projector<3>(with(32, seed), VolumeKind::box);
  const auto again = make_projector<3>(with(32, 1), VolumeKind::box);
  EXPECT_NE(again, first) << "old ones are forgotten";
  ASSERT_EQ(again->directions().size(), first->directions().size());
  for (std::uint32_t k = 0; k < first->directions().size(); ++k)
    EXPECT_EQ(again->directions()[k], first->directions()[k]);
}

TEST(MakeProjector, WhateverDiffersMakesAnother) {
  const auto first = make_projector<3>(with(32, 1), VolumeKind::box);
  EXPECT_EQ(make_projector<3>(with(48, 1), VolumeKind::box)->directions().size(), 48U);
  EXPECT_NE(make_projector<3>(with(32, 7), VolumeKind::box)->directions()[5], first->directions()[5]);
  EXPECT_EQ(make_projector<3>(with(32, 1), VolumeKind::sphere)->kind(), VolumeKind::sphere);
  EXPECT_EQ(make_projector<2>(with(32, 1), VolumeKind::box)->directions().size(), 8U);
}

TEST(MakeProjector, ThereAreOnlyVolumesOfTheDimension) {
  EXPECT_NO_THROW((void)make_projector<2>(Config{}, VolumeKind::dop8));
  EXPECT_NO_THROW((void)make_projector<3>(Config{}, VolumeKind::dop14));
  for (const VolumeKind kind : {VolumeKind::dop8, VolumeKind::dop16})
    EXPECT_THROW((void)make_projector<3>(Config{}, kind), std::invalid_argument);
  for (const VolumeKind kind : {VolumeKind::dop14, VolumeKind::dop26})
    EXPECT_THROW((void)make_projector<2>(Config{}, kind), std::invalid_argument);
}

}  // namespace
}  // namespace kerf::test
