#include "core/related/kinetic_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kerf {
namespace {

constexpr std::uint32_t kForever = std::numeric_limits<std::uint32_t>::max();
constexpr double kOfExtent = 1e-3;  ///< tolerance of a course
constexpr double kOfBounds = 1e-6;  ///< the same, for what floats round away

/// The last step from `from` on at which something with this velocity has not come as far as `distance`.
std::uint32_t last_before(double distance, double velocity, double tolerance, std::uint32_t from) {
  if (distance <= tolerance) return from;
  if (velocity <= 0) return kForever;
  const double steps = std::ceil((distance - tolerance) / velocity) - 1;
  return steps < static_cast<double>(kForever - from)
             ? from + static_cast<std::uint32_t>(std::max(0.0, steps))
             : kForever;
}

}  // namespace

template <int D>
typename KineticTree<D>::Bounds KineticTree<D>::bounds_of(const Box<D>& box) {
  Bounds bounds{};
  for (int i = 0; i < D; ++i) {
    bounds[static_cast<std::size_t>(i)] = double{box.min[i]};
    bounds[static_cast<std::size_t>(i + D)] = double{box.max[i]};
  }
  return bounds;
}

template <int D>
std::uint32_t KineticTree<D>::holds_until(const Course& course, const Box<D>& box) const {
  const CutTree<D>& tree = this->tree();
  std::uint32_t until = kForever;
  const auto limit = [&](double distance, double velocity) {
    until = std::min(until, last_before(distance, velocity, course.tolerance, course.from));
  };
  std::vector<Index> todo{tree.root()};
  while (!todo.empty()) {
    const auto& node = tree[todo.back()];
    todo.pop_back();
    if (node.is_leaf()) continue;
    const auto lower = static_cast<std::size_t>(node.axis);
    const std::size_t upper = lower + D;
    const double cut = double{node.cut};
    const bool is_below = box.min[node.axis] < node.cut;
    const bool is_above = box.max[node.axis] >= node.cut;
    if (is_below) {
      todo.push_back(node.below);
      if (is_above) limit(cut - course.begin[lower], course.velocity[lower]);
      if (!is_above) limit(cut - course.begin[upper], course.velocity[upper]);
    }
    if (is_above) {
      todo.push_back(node.above);
      if (is_below) limit(course.begin[upper] - cut, -course.velocity[upper]);
      if (!is_below) limit(course.begin[lower] - cut, -course.velocity[lower]);
    }
  }
  return until;
}

template <int D>
void KineticTree<D>::certify(ObjectId object, const Bounds& velocity) {
  const Box<D>& box = this->tree().box(object);
  Course& course = courses_[object.index()];
  course = {bounds_of(box), velocity, 0, step_, step_};
  double extent = 0;
  double size = 0;
  for (std::size_t i = 0; i < D; ++i) {
    extent = std::max(extent, course.begin[i + D] - course.begin[i]);
    size = std::max({size, std::abs(course.begin[i]), std::abs(course.begin[i + D])});
  }
  course.tolerance = kOfExtent * extent + kOfBounds * size;
  course.until = holds_until(course, box);
}

template <int D>
bool KineticTree<D>::is_on_course(const Course& course, const Bounds& bounds) const {
  const double steps = step_ - course.from;
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    const double expected = course.begin[i] + steps * course.velocity[i];
    if (!(std::abs(bounds[i] - expected) < course.tolerance)) return false;
  }
  return true;
}

/// An object that has moved.
template <int D>
void KineticTree<D>::follow(ObjectId object) {
  CutTree<D>& tree = this->cuts();
  const Box<D>& box = this->table().box(object);
  const Course& course = courses_[object.index()];
  const Bounds now = bounds_of(box);
  const bool is_expected = is_on_course(course, now);
  if (is_expected && step_ <= course.until) return tree.set_box(object, box);
  ++(is_expected ? failures_ : surprises_);
  Bounds velocity = course.velocity;
  if (!is_expected) {
    const Bounds before = bounds_of(tree.box(object));
    for (std::size_t i = 0; i < now.size(); ++i) velocity[i] = now[i] - before[i];
  }
  tree.remove(tree.root(), object);
  tree.insert(tree.root(), object, box, leaves_);
  certify(object, velocity);
}

template <int D>
void KineticTree<D>::build() {
  this->rebuild();
  entries_when_built_ = this->tree().entries();
  for (const ObjectId object : this->placed()) certify(object, courses_[object.index()].velocity);
}

template <int D>
void KineticTree<D>::arrange() {
  CutTree<D>& tree = this->cuts();
  ++step_;
  failures_ = surprises_ = 0;
  leaves_.clear();
  const auto changes = this->take_changes();
  courses_.resize(this->table().bound());
  for (const ObjectId object : changes.gone) tree.remove(tree.root(), object);
  for (const ObjectId object : changes.moved) follow(object);
  for (const ObjectId object : changes.come) {
    tree.insert(tree.root(), object, this->table().box(object), leaves_);
    certify(object, {});
  }
  constexpr std::size_t kFew = CutTree<D>::kCrowded;
  if (tree.entries() > 2 * entries_when_built_ + kFew) build();
}

template class KineticTree<2>;
template class KineticTree<3>;

}  // namespace kerf
