// A posed shape lies inside of its volume, whatever the kind, the pose and the scale. Engines keep poses in
// doubles: what is rounded must be rounded outward, or a contact falls between (DESIGN.md, "Borders").

#include "core/scene/bounding.h"

#include <gtest/gtest.h>

#include "core/geometry/slabs.h"
#include "tests/property/turn.h"
#include "tests/support/dimensions.h"

namespace kerf::test {
namespace {

using Long = long double;  // 64 bits of mantissa: the judge rounds less than the judged

template <int D>
using Place = std::array<Long, D>;

template <int D>
Long along(const Place<D>& point, const Scalar* direction) {
  Long sum = 0;
  for (std::size_t i = 0; i < D; ++i) sum += point[i] * static_cast<Long>(direction[i]);
  return sum;
}

template <int D>
bool is_inside_box(const Place<D>& point, const Box<D>& box) {
  bool all = true;
  for (std::size_t i = 0; i < D; ++i)
    all &= static_cast<Long>(box.min.value[i]) <= point[i] && point[i] <= static_cast<Long>(box.max.value[i]);
  return all;
}

template <int D>
Place<D> from_center(const Place<D>& point, const Volume<D>& volume) {
  Place<D> apart = point;
  for (std::size_t i = 0; i < D; ++i) apart[i] -= static_cast<Long>(volume.extra[i]);
  return apart;
}

/// Whether the volume without its box holds the point.
template <int D>
bool is_inside(const Place<D>& point, const Volume<D>& volume) {
  const Scalar* extra = volume.extra.data();
  if (volume.kind == VolumeKind::sphere) {
    Long apart2 = 0;
    for (const Long x : from_center<D>(point, volume)) apart2 += x * x;
    return apart2 <= static_cast<Long>(extra[D]) * static_cast<Long>(extra[D]);
  }
  bool all = true;
  if (volume.kind == VolumeKind::oriented_box) {
    for (int k = 0; k < D; ++k)
      all &= std::abs(along<D>(from_center<D>(point, volume), extra + D + k * D)) <=
             static_cast<Long>(extra[D + D * D + k]);
  } else if (volume.kind != VolumeKind::box) {
    const auto slabs = slab_directions<D>(volume.kind);
    for (std::size_t k = D; k < slabs.size(); ++k) {
      const Long at = along<D>(point, slabs[k].value.data());
      all &= static_cast<Long>(extra[2 * (k - D)]) <= at && at <= static_cast<Long>(extra[2 * (k - D) + 1]);
    }
  }
  return all;
}

template <int D>
PrecisePose<D> random_pose(Random& random) {
  PrecisePose<D> pose;
  const double far = std::pow(10, random.uniform(-3, 6));
  for (double& x : pose.position) x = random.uniform(-far, far);
  for (std::size_t k = 0; k < D; ++k) pose.axes[k][k] = 1;
  for (int turn = 0; turn < 3; ++turn) {
    const double angle = random.uniform(0, 7);
    const std::uint32_t first = random.below(D);
    const std::uint32_t second = (first + 1) % D;
    for (auto& axis : pose.axes) {
      const double a = axis[first];
      axis[first] = std::cos(angle) * a - std::sin(angle) * axis[second];
      axis[second] = std::sin(angle) * a + std::cos(angle) * axis[second];
    }
  }
  return pose;
}

/// Where a point of the body's frame is in the world.
template <int D>
Place<D> in_world(const PrecisePose<D>& pose, const std::array<double, D>& local) {
  Place<D> place;
  for (std::size_t i = 0; i < D; ++i) {
    place[i] = static_cast<Long>(pose.position[i]);
    for (std::size_t k = 0; k < D; ++k)
      place[i] += static_cast<Long>(local[k]) * static_cast<Long>(pose.axes[k][i]);
  }
  return place;
}

template <class T>
class Bounding : public testing::Test {
 protected:
  static constexpr int kD = T::value;

  /// Bounds a shape at many poses. `point_of(random)` is any of its points, in the body's frame.
  template <class PointOf>
  void expect_inside(const Shape<kD>& shape, PointOf point_of) {
    Random random(31);
    for (const VolumeKind kind : volume_kinds<kD>()) {
      int outside = 0;
      for (int i = 0; i < 500; ++i) {
        const PrecisePose<kD> pose = random_pose<kD>(random);
        const Volume<kD> volume = bound<kD>(kind, shape, pose);
        for (int k = 0; k < 16; ++k) {
          const Place<kD> point = in_world<kD>(pose, point_of(random));
          if (!is_inside_box<kD>(point, volume.box) || !is_inside<kD>(point, volume)) ++outside;
        }
      }
      EXPECT_EQ(outside, 0) << to_string(kind);
    }
  }
};
TYPED_TEST_SUITE(Bounding, Dimensions, DimensionNames);

TYPED_TEST(Bounding, HoldsTheCornersOfABrick) {
  constexpr std::size_t kAxes = TypeParam::value;
  Brick<TypeParam::value> brick;
  for (std::size_t k = 0; k < kAxes; ++k) brick.half.value[k] = 0.1F + 0.7F * static_cast<Scalar>(k);
  this->expect_inside(brick, [&](Random& random) {
    std::array<double, kAxes> corner;
    for (std::size_t k = 0; k < kAxes; ++k)
      corner[k] = static_cast<double>(random.below(2) == 0 ? brick.half.value[k] : -brick.half.value[k]);
    return corner;
  });
}

TYPED_TEST(Bounding, HoldsTheSurfaceOfABall) {
  const Ball ball{0.37F};
  this->expect_inside(ball, [&](Random& random) {
    // A hair inside: a unit direction in doubles is a hair too long or too short.
    Precise<TypeParam::value> point = random_unit<TypeParam::value>(random);
    for (double& x : point) x *= static_cast<double>(ball.radius) * (1 - 0x1p-50);
    return point;
  });
}

}  // namespace
}  // namespace kerf::test
