#include "tests/sims2d/shapes.h"

#include <cmath>
#include <numbers>

namespace kerf::test {
namespace {

std::vector<Vector<2>> local_rim(const Shape<2>& shape) {
  std::vector<Vector<2>> points;
  if (const auto* outline = std::get_if<Outline>(&shape)) return outline->corners;
  if (const auto* brick = std::get_if<Brick<2>>(&shape)) {
    const Vector<2> h = brick->half;
    return {{{-h[0], -h[1]}}, {{h[0], -h[1]}}, {{h[0], h[1]}}, {{-h[0], h[1]}}};
  }
  for (int i = 0; i < 64; ++i) {
    const auto angle = static_cast<Scalar>(i * std::numbers::pi / 32);
    points.push_back(Vector<2>{{std::cos(angle), std::sin(angle)}} * std::get<Ball>(shape).radius);
  }
  return points;
}

}  // namespace

std::vector<Vector<2>> rim(const Body<2>& body) {
  std::vector<Vector<2>> points = local_rim(body.shape);
  for (Vector<2>& p : points) p = body.pose.position + body.pose.axes[0] * p[0] + body.pose.axes[1] * p[1];
  return points;
}

Shape<2> diamond() { return Outline{{{{0.5F, 0}}, {{0, 0.5F}}, {{-0.5F, 0}}, {{0, -0.5F}}}}; }

}  // namespace kerf::test
