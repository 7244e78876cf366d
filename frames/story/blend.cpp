#include "frames/story/blend.h"

#include <algorithm>

namespace kerf {
namespace {

template <int D>
Vector<D> between(const Vector<D>& a, const Vector<D>& b, Scalar part) {
  return a + (b - a) * part;
}

/// A turn of a few degrees: the axes stay nearly square and need only their length.
template <int D>
Vector<D> turned(const Vector<D>& a, const Vector<D>& b, Scalar part) {
  const Vector<D> axis = between<D>(a, b, part);
  const Scalar size = length(axis);
  return size > Scalar{0.1F} ? axis * (1 / size) : b;
}

}  // namespace

template <int D>
std::vector<Body<D>> blend(const std::vector<Body<D>>& from, const std::vector<Body<D>>& to, double part) {
  std::vector<Body<D>> bodies = from;
  const auto t = static_cast<Scalar>(part);
  for (std::size_t k = 0; k < std::min(from.size(), to.size()); ++k) {
    Body<D>& body = bodies[k];
    body.pose.position = between<D>(body.pose.position, to[k].pose.position, t);
    for (std::size_t axis = 0; axis < D; ++axis)
      body.pose.axes[axis] = turned<D>(body.pose.axes[axis], to[k].pose.axes[axis], t);
    body.box.min = between<D>(body.box.min, to[k].box.min, t);
    body.box.max = between<D>(body.box.max, to[k].box.max, t);
  }
  return bodies;
}

template std::vector<Body<2>> blend(const std::vector<Body<2>>&, const std::vector<Body<2>>&, double);
template std::vector<Body<3>> blend(const std::vector<Body<3>>&, const std::vector<Body<3>>&, double);

}  // namespace kerf
