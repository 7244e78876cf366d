#include "viz/draw/shading.h"

#include <algorithm>

namespace kerf {
namespace {

constexpr double kAmbient = 0.62;
constexpr double kBrightest = 1.08;
constexpr double kMostHaze = 0.28;

}  // namespace

Eigen::Vector3d light_of(const View& view) {
  const Eigen::Vector3d level(view.forward.z(), 0, -view.forward.x());
  return (Eigen::Vector3d(0, 1.2, 0) - 0.7 * view.forward + 0.5 * level).normalized();
}

Color lit_face(Color color, double cosine) {
  return lit(color, kAmbient + (kBrightest - kAmbient) * std::max(0.0, cosine));
}

double clearness(const View& view, const Eigen::Vector3d& point) {
  const double share = view.depth_share(point);
  return 1 - kMostHaze * share * share;
}

}  // namespace kerf
