#include "sims3d/geoms.h"

#include <gmock/gmock.h>

#include <array>
#include <stdexcept>

#include "core/base/random.h"
#include "sims3d/ode/geom_box.h"

namespace kerf {
namespace {

TEST(Geoms, BoxesAreRoundedOutward) {
  const OdeLibrary library;
  const auto lock = library.enter();
  const Geom geom = make_geom(Brick<3>{{{0.3F, 0.4F, 0.5F}}});
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const double x = random.uniform(-50, 50);
    const double angle = random.uniform(0, 6);
    dMatrix3 rotation{};
    dRFromAxisAndAngle(rotation, 1, 2, 3, angle);
    dGeomSetPosition(geom.geom.get(), x, x * 1e3, x * 1e6);
    dGeomSetRotation(geom.geom.get(), rotation);
    std::array<dReal, 6> exact{};
    dGeomGetAABB(geom.geom.get(), exact.data());
    const Box<3> box = outward_box(geom.geom.get());
    for (int axis = 0; axis < 3; ++axis) {
      const std::size_t k = 2 * static_cast<std::size_t>(axis);
      ASSERT_LE(static_cast<double>(box.min[axis]), exact[k]);
      ASSERT_GE(static_cast<double>(box.max[axis]), exact[k + 1]);
    }
  }
}

TEST(Geoms, AxesOfAPoseAreWhereTheBodysAxesPoint) {
  const OdeLibrary library;
  const auto lock = library.enter();
  const Geom geom = make_geom(Brick<3>{{{1, 2, 3}}});
  dMatrix3 quarter_turn{};
  dRFromAxisAndAngle(quarter_turn, 0, 1, 0, M_PI / 2);  // takes X to -Z and Z to X
  dGeomSetRotation(geom.geom.get(), quarter_turn);
  const Pose<3> pose = pose_of(geom.geom.get());
  EXPECT_NEAR(pose.axes[0][2], -1, 1e-6);
  EXPECT_NEAR(pose.axes[1][1], 1, 1e-6);
  EXPECT_NEAR(pose.axes[2][0], 1, 1e-6);
}

TEST(Geoms, MassFollowsFromVolume) {
  EXPECT_NEAR(make_mass(Brick<3>{{{0.5F, 1, 1.5F}}}, 2).mass, 2 * 1 * 2 * 3, 1e-9);
  EXPECT_NEAR(make_mass(Ball{1}, 1).mass, 4.0 / 3 * M_PI, 1e-9);
  EXPECT_THROW(make_mass(std::make_shared<const Surface>(), 1), std::invalid_argument);
}

}  // namespace
}  // namespace kerf
