#include "core/scene/bounding.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

#include "core/geometry/precise.h"
#include "core/geometry/slabs.h"

namespace kerf {
namespace {

/// The nearest finite float: rounding may carry a value at the end of the range beyond it.
Scalar nearest_finite(double x) {
  constexpr auto kMax = static_cast<double>(std::numeric_limits<Scalar>::max());
  return static_cast<Scalar>(std::clamp(x, -kMax, kMax));
}

/// Ends of a projection in doubles, with a bound of their rounding error.
struct Extent {
  double lo = 0;
  double hi = 0;
};

/// A shape at a pose, with its projection along any direction.
template <int D>
class PosedShape {
 public:
  PosedShape(const Shape<D>& shape, const PrecisePose<D>& pose, double margin)
      : pose_(pose), margin_(margin) {
    std::visit([this](const auto& s) { this->take(s); }, shape);
  }

  [[nodiscard]] Extent extent(const Precise<D>& direction) const {
    const double length = std::sqrt(inner<D>(direction, direction));
    const double middle = inner<D>(direction, pose_.position);
    Precise<D> local;  // the direction in the body's frame
    for (std::size_t k = 0; k < D; ++k) local[k] = inner<D>(direction, pose_.axes[k]);
    Extent along = corners_.empty() ? Extent{} : Extent{kInfinity, -kInfinity};
    for (const Precise<D>& corner : corners_) {
      const double at = inner<D>(local, corner);
      along = {std::min(along.lo, at), std::max(along.hi, at)};
    }
    double reach = (radius_ + margin_) * length;
    for (std::size_t k = 0; k < D; ++k) reach += half_[k] * std::abs(local[k]);
    double size = reach + std::max(std::abs(along.lo), std::abs(along.hi));
    for (std::size_t i = 0; i < D; ++i) size += std::abs(direction[i] * pose_.position[i]);
    const double lost = size * 0x1p-46;  // some twenty roundings of 2^-53 each
    return {middle + along.lo - reach - lost, middle + along.hi + reach + lost};
  }

  /// Radius around the body's origin that holds the shape.
  [[nodiscard]] double radius() const {
    double far2 = inner<D>(half_, half_);
    for (const Precise<D>& corner : corners_) far2 = std::max(far2, inner<D>(corner, corner));
    return (std::sqrt(far2) + radius_ + margin_) * (1 + 0x1p-46);
  }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  void take(const Ball& ball) { radius_ = static_cast<double>(ball.radius); }
  void take(const Brick<D>& brick) { half_ = to_precise<D>(brick.half); }
  void take(const Outline& outline) {
    for (const Vector<2>& corner : outline.corners) corners_.push_back(to_precise(corner));
  }
  template <class Mesh>
  void take(const std::shared_ptr<Mesh>& surface) {
    for (const Vector<3>& vertex : surface->vertices) corners_.push_back(to_precise(vertex));
  }

  PrecisePose<D> pose_;
  double margin_;
  double radius_ = 0;
  Precise<D> half_{};
  std::vector<Precise<D>> corners_;
};

template <int D>
Volume<D> bounding_sphere(const PosedShape<D>& posed, const PrecisePose<D>& pose) {
  Vector<D> center;
  double moved2 = 0;  // what the float centre is off
  for (int i = 0; i < D; ++i) {
    const double exact = pose.position[static_cast<std::size_t>(i)];
    center[i] = nearest_finite(exact);
    moved2 += (static_cast<double>(center[i]) - exact) * (static_cast<double>(center[i]) - exact);
  }
  const double radius = (posed.radius() + std::sqrt(moved2)) * (1 + 0x1p-46);
  // No finite float is large enough then: the sphere holds all space.
  const bool beyond = radius > static_cast<double>(std::numeric_limits<Scalar>::max());
  return make_sphere<D>(center, beyond ? std::numeric_limits<Scalar>::infinity() : round_up(radius));
}

/// The oriented box along the body's axes, rounded to float. Along rounded axes the shape reaches a little
/// farther than along the exact ones: a slack of 2^-20 of its size is eight times that.
template <int D>
Volume<D> oriented_bounding_box(const PosedShape<D>& posed, const PrecisePose<D>& pose) {
  std::array<Vector<D>, D> axes;
  std::array<Extent, D> extents;
  Precise<D> middle{};
  double size = 0;
  for (std::size_t k = 0; k < D; ++k) {
    for (std::size_t i = 0; i < D; ++i) axes[k].value[i] = static_cast<Scalar>(pose.axes[k][i]);
    extents[k] = posed.extent(to_precise(axes[k]));
    const double along = (extents[k].lo + extents[k].hi) / 2;
    for (std::size_t i = 0; i < D; ++i) middle[i] += along * pose.axes[k][i];
    size += extents[k].hi - extents[k].lo;
  }
  Vector<D> center;
  Vector<D> half;
  for (std::size_t i = 0; i < D; ++i) center.value[i] = nearest_finite(middle[i]);
  const Precise<D> floated = to_precise(center);
  for (std::size_t k = 0; k < D; ++k) {
    const double at = inner<D>(floated, to_precise(axes[k]));
    const double lost = std::sqrt(inner<D>(floated, floated)) * 0x1p-46 + size * 0x1p-20;
    half.value[k] = round_up(std::max(extents[k].hi - at, at - extents[k].lo) + lost);
  }
  return make_oriented_box<D>(center, axes, half);
}

}  // namespace

template <int D>
PrecisePose<D> precise(const Pose<D>& pose) {
  PrecisePose<D> result;
  result.position = to_precise(pose.position);
  for (std::size_t k = 0; k < D; ++k) result.axes[k] = to_precise(pose.axes[k]);
  return result;
}

template <int D>
Volume<D> bound(VolumeKind kind, const Shape<D>& shape, const PrecisePose<D>& pose, double margin) {
  const PosedShape<D> posed(shape, pose, margin);
  std::vector<Interval> slabs;
  for (const Vector<D>& direction : slab_directions<D>(kind)) {
    const Extent extent = posed.extent(to_precise(direction));
    slabs.push_back({round_down(extent.lo), round_up(extent.hi)});
  }
  Volume<D> volume = make_dop<D>(kind, slabs);  // for every kind the first slabs are the box
  const Box<D> box = volume.box;
  if (kind == VolumeKind::sphere) volume = bounding_sphere(posed, pose);
  if (kind == VolumeKind::oriented_box) volume = oriented_bounding_box(posed, pose);
  volume.box = box;  // tighter than the volume's own
  return volume;
}

template PrecisePose<2> precise<2>(const Pose<2>&);
template PrecisePose<3> precise<3>(const Pose<3>&);
template Volume<2> bound<2>(VolumeKind, const Shape<2>&, const PrecisePose<2>&, double);
template Volume<3> bound<3>(VolumeKind, const Shape<3>&, const PrecisePose<3>&, double);

}  // namespace kerf
