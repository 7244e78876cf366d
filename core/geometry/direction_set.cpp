#include "core/geometry/direction_set.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "core/base/random.h"
#include "core/geometry/precise.h"
#include "core/geometry/usual_directions.h"

namespace kerf {
namespace {

// Everything here is +, -, *, / and sqrt on doubles: correctly rounded operations, so every machine agrees.

template <int D>
void normalize(Precise<D>& p) {
  const double norm = std::sqrt(inner<D>(p, p));
  for (double& x : p) x /= norm;
}

template <int D>
Precise<D> random_direction(Random& random) {
  while (true) {
    Precise<D> p;
    for (double& x : p) x = random.uniform(-1, 1);
    const double norm2 = inner<D>(p, p);
    if (norm2 > 1 || norm2 < 1e-4) continue;
    normalize<D>(p);
    return p;
  }
}

/// |cosine| of the angle to the nearest of `points`, taken as lines: 1 on top of one, 0 at right angles to
/// all.
template <int D>
double nearness(const Precise<D>& p, std::span<const Precise<D>> points) {
  double nearest = 0;
  for (const Precise<D>& q : points) nearest = std::max(nearest, std::abs(inner<D>(p, q)));
  return nearest;
}

/// The axes, then repeatedly the candidate farthest from all points so far: an even start for the repulsion.
template <int D>
std::vector<Precise<D>> scatter(std::uint32_t size, Random& random) {
  constexpr int kTries = 16;
  std::vector<Precise<D>> points;
  for (std::size_t i = 0; i < D; ++i) {
    points.push_back({});
    points.back()[i] = 1;
  }
  while (points.size() < size) {
    Precise<D> best = random_direction<D>(random);
    double best_nearness = nearness<D>(best, points);
    for (int i = 1; i < kTries; ++i) {
      const Precise<D> candidate = random_direction<D>(random);
      const double near = nearness<D>(candidate, points);
      if (near < best_nearness) {
        best = candidate;
        best_nearness = near;
      }
    }
    points.push_back(best);
  }
  return points;
}

/// Adds to `force` the push that a line through q gives a point p of the sphere: from q and from -q, each
/// with the inverse square of its distance.
template <int D>
void add_push(const Precise<D>& p, const Precise<D>& q, Precise<D>& force) {
  for (const double sign : {1.0, -1.0}) {
    Precise<D> away;
    for (std::size_t i = 0; i < D; ++i) away[i] = p[i] - sign * q[i];
    const double distance2 = std::max(inner<D>(away, away), 1e-12);
    const double scale = 1 / (distance2 * std::sqrt(distance2));
    for (std::size_t i = 0; i < D; ++i) force[i] += scale * away[i];
  }
}

/// One round of repulsion. Only the axes are fixed; no point moves farther than `reach`.
template <int D>
void repel(std::vector<Precise<D>>& points, double reach) {
  const std::vector<Precise<D>> before = points;
  for (std::size_t k = D; k < points.size(); ++k) {
    Precise<D> force{};
    for (std::size_t j = 0; j < before.size(); ++j)
      if (j != k) add_push<D>(before[k], before[j], force);
    const double radial = inner<D>(force, before[k]);
    for (std::size_t i = 0; i < D; ++i) force[i] -= radial * before[k][i];
    const double strength = std::sqrt(inner<D>(force, force));
    if (strength == 0) continue;
    const double scale = reach / (strength + static_cast<double>(points.size()));
    for (std::size_t i = 0; i < D; ++i) points[k][i] += scale * force[i];
    normalize<D>(points[k]);
  }
}

/// Orders the directions behind the axes: next comes always the one farthest from all before it.
template <int D>
void order_by_loneliness(std::vector<Precise<D>>& points) {
  std::vector<double> near(points.size(), 0);
  std::size_t done = 0;
  const auto settle = [&] {
    for (std::size_t k = done + 1; k < points.size(); ++k)
      near[k] = std::max(near[k], std::abs(inner<D>(points[k], points[done])));
    ++done;
  };
  while (done < D) settle();
  while (done < points.size()) {
    const auto loneliest = std::min_element(near.begin() + static_cast<std::ptrdiff_t>(done), near.end());
    const auto k = static_cast<std::size_t>(loneliest - near.begin());
    std::swap(points[done], points[k]);
    std::swap(near[done], near[k]);
    settle();
  }
}

template <int D>
bool can_divide(const Vector<D>& direction) {
  bool within = true;  // false for NaN
  for (const Scalar x : direction.value) within &= x >= -1 && x <= 1;
  return within && direction != Vector<D>{};
}

/// The float direction, turned into the hemisphere where the last component that is not 0 is positive.
template <int D>
Vector<D> to_hemisphere(const Precise<D>& p) {
  Vector<D> v;
  for (int i = 0; i < D; ++i) v[i] = static_cast<Scalar>(p[static_cast<std::size_t>(i)]);
  int last = D - 1;
  while (last > 0 && v[last] == 0) --last;
  return v[last] < 0 ? v * -1 : v;
}

}  // namespace

template <int D>
DirectionSet<D>::DirectionSet(std::uint32_t size, std::uint64_t seed) {
  if (size < D || size > 4096)
    throw std::invalid_argument("direction set: size " + std::to_string(size) + " is not between " +
                                std::to_string(D) + " and 4096");
  if (size == kUsualDirections<D> && seed == kUsualSeed) {
    const std::span<const Vector<D>> usual = usual_directions<D>();
    directions_.assign(usual.begin(), usual.end());
  } else {
    directions_ = spread_directions<D>(size, seed);
  }
}

template <int D>
std::vector<Vector<D>> spread_directions(std::uint32_t size, std::uint64_t seed) {
  constexpr int kRounds = 40;
  Random random(seed);
  std::vector<Precise<D>> points = scatter<D>(size, random);
  const double spacing = D == 2 ? 3.0 / size : 2.5 / std::sqrt(static_cast<double>(size));
  for (int round = 0; round < kRounds; ++round)
    repel<D>(points, spacing * static_cast<double>(kRounds - round) / kRounds);
  order_by_loneliness<D>(points);
  std::vector<Vector<D>> directions;
  for (const Precise<D>& p : points) directions.push_back(to_hemisphere<D>(p));
  return directions;
}

template <int D>
DirectionSet<D>::DirectionSet(std::span<const Vector<D>> directions) {
  for (int i = 0; i < D; ++i) directions_.push_back(axis_vector<D>(i));
  for (const Vector<D>& direction : directions) {
    if (!can_divide(direction))
      throw std::invalid_argument("direction set: direction " + std::to_string(directions_.size() - D) +
                                  " is zero or has a component that is no number from -1 to 1");
    directions_.push_back(direction);
  }
}

template std::vector<Vector<2>> spread_directions<2>(std::uint32_t, std::uint64_t);
template std::vector<Vector<3>> spread_directions<3>(std::uint32_t, std::uint64_t);
template class DirectionSet<2>;
template class DirectionSet<3>;

}  // namespace kerf
