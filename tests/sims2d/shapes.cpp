#include "tests/sims2d/shapes.h"

#include <cmath>
#include <numbers>

#include "core/base/overloaded.h"

namespace kerf::test {
namespace {

using Points = std::vector<Vector<2>>;

Points circle(const Ball& ball) {
  Points points;
  for (int i = 0; i < 64; ++i) {
    const auto angle = static_cast<Scalar>(i * std::numbers::pi / 32);
    points.push_back(Vector<2>{{std::cos(angle), std::sin(angle)}} * ball.radius);
  }
  return points;
}

Points local_rim(const Shape<2>& shape) {
  const auto corners = [](const Brick<2>& brick) {
    const Vector<2> h = brick.half;
    return Points{{{-h[0], -h[1]}}, {{h[0], -h[1]}}, {{h[0], h[1]}}, {{-h[0], h[1]}}};
  };
  return std::visit(Overloaded{[](const Ball& ball) { return circle(ball); }, corners,
                               [](const Outline& outline) { return outline.corners; }},
                    shape);
}

}  // namespace

std::vector<Vector<2>> rim(const Body<2>& body) {
  std::vector<Vector<2>> points = local_rim(body.shape);
  for (Vector<2>& p : points) p = body.pose.position + body.pose.axes[0] * p[0] + body.pose.axes[1] * p[1];
  return points;
}

Shape<2> diamond() { return Outline{{{{0.5F, 0}}, {{0, 0.5F}}, {{-0.5F, 0}}, {{0, -0.5F}}}}; }

}  // namespace kerf::test
