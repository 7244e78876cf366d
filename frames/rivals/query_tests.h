#pragma once

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "core/spatial/query.h"

namespace kerf {

// The tests that a library leaves its caller to make, in floats, as one would write them.

/// A ray with what is computed once for it.
template <int D>
struct QuickRay {
  QuickRay(const Vector<D>& from, const Vector<D>& direction, const Box<D>& moved, Scalar length)
      : origin(from), shape(moved), max_t(length) {
    constexpr Scalar kMax = std::numeric_limits<Scalar>::max();
    for (int i = 0; i < D; ++i) inverse[i] = direction[i] == 0 ? kMax : 1 / direction[i];
  }
  explicit QuickRay(const Ray<D>& ray) : QuickRay(ray.origin, ray.direction, {}, ray.max_t) {}
  explicit QuickRay(const SweptBox<D>& swept) : QuickRay({}, swept.displacement, swept.box, swept.max_t) {}

  /// Where it enters a box.
  [[nodiscard]] std::optional<Scalar> enter(const Box<D>& box) const {
    Scalar begin = 0;
    Scalar end = max_t;
    for (int i = 0; i < D; ++i) {
      const Scalar a = (box.min[i] - shape.max[i] - origin[i]) * inverse[i];
      const Scalar b = (box.max[i] - shape.min[i] - origin[i]) * inverse[i];
      begin = std::max(begin, std::min(a, b));
      end = std::min(end, std::max(a, b));
    }
    return begin <= end ? std::optional(begin) : std::nullopt;
  }

  Vector<D> origin;
  Box<D> shape;  ///< relative to the origin
  Vector<D> inverse;
  Scalar max_t;
};

template <int D>
Scalar quick_distance(const Vector<D>& point, const Box<D>& box) {
  Scalar sum = 0;
  for (int i = 0; i < D; ++i) {
    const Scalar apart = std::max({box.min[i] - point[i], point[i] - box.max[i], Scalar{0}});
    sum += apart * apart;
  }
  return sum;
}

/// The nearest few, as a heap.
class QuickNearest {
 public:
  QuickNearest(std::size_t count, std::vector<Neighbour>& found) : count_(count), found_(found) {}
  void take(ObjectId object, double squared_distance) {
    const Neighbour next{object, squared_distance};
    if (is_full()) {
      if (!(next < found_.front())) return;
      std::ranges::pop_heap(found_, std::less<>());
      found_.back() = next;
    } else {
      found_.push_back(next);
    }
    std::ranges::push_heap(found_, std::less<>());
  }
  [[nodiscard]] bool is_full() const { return found_.size() == count_; }
  /// Of the farthest.
  [[nodiscard]] double squared_distance() const { return found_.front().squared_distance; }

 private:
  std::size_t count_;
  std::vector<Neighbour>& found_;
};

}  // namespace kerf
