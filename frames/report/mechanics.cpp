#include "frames/report/mechanics.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "core/broad_phase/all_pairs.h"
#include "frames/report/contact_probe.h"

namespace kerf {
namespace {

constexpr double kStepSeconds = 1.0 / 25;
constexpr int kUp = 1;

/// Of both engines' worlds, Box2D's being a little heavier.
template <int D>
constexpr double kGravity = D == 2 ? 10 : 9.81;

double area(const Outline& outline) {
  double twice = 0;
  for (std::size_t i = 0; i < outline.corners.size(); ++i) {
    const Vector<2>& a = outline.corners[i];
    const Vector<2>& b = outline.corners[(i + 1) % outline.corners.size()];
    twice += static_cast<double>(a[0]) * static_cast<double>(b[1]) -
             static_cast<double>(a[1]) * static_cast<double>(b[0]);
  }
  return twice / 2;
}

template <int D>
struct SizeOf {
  double operator()(const Ball& ball) const {
    const auto r = static_cast<double>(ball.radius);
    return D == 2 ? std::numbers::pi * r * r : std::numbers::pi * 4 / 3 * r * r * r;
  }
  double operator()(const Brick<D>& brick) const {
    double size = 1;
    for (int i = 0; i < D; ++i) size *= 2 * static_cast<double>(brick.half[i]);
    return size;
  }
  double operator()(const Outline& outline) const { return area(outline); }
  double operator()(const std::shared_ptr<const Surface>& /*surface*/) const { return 0; }
};

template <int D>
double distance_squared(const Vector<D>& a, const Vector<D>& b) {
  double sum = 0;
  for (int i = 0; i < D; ++i) {
    const double apart = static_cast<double>(a[i]) - static_cast<double>(b[i]);
    sum += apart * apart;
  }
  return sum;
}

template <int D>
std::vector<Pair> pairs_of(std::span<const Body<D>> bodies) {
  AllPairs<D> oracle;
  for (std::uint32_t k = 0; k < bodies.size(); ++k)
    static_cast<void>(oracle.insert({k}, bodies[k].box, bodies[k].mobility));
  oracle.step();
  return {oracle.pairs().begin(), oracle.pairs().end()};
}

}  // namespace

template <int D>
double size_of(const Shape<D>& shape) {
  return std::visit(SizeOf<D>{}, shape);
}

template <int D>
double energy_height(std::span<const Body<D>> bodies, std::span<const Vector<D>> before) {
  double energy = 0;
  double weight = 0;
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    if (bodies[k].mobility == Mobility::fixed) continue;
    const double mass = size_of<D>(bodies[k].shape);
    const double moved2 = k < before.size() ? distance_squared(bodies[k].pose.position, before[k]) : 0;
    const double speed2 = moved2 / (kStepSeconds * kStepSeconds);
    const auto height = static_cast<double>(bodies[k].pose.position[kUp]);
    energy += mass * (speed2 / 2 + kGravity<D> * height);
    weight += mass * kGravity<D>;
  }
  return weight > 0 ? energy / weight : 0;
}

template <int D>
double deepest_penetration(std::span<const Body<D>> bodies) {
  ContactProbe<D> probe;
  for (std::uint32_t k = 0; k < bodies.size(); ++k) {
    probe.add(bodies[k].shape);
    probe.place({k}, bodies[k].pose);
  }
  double deepest = 0;
  for (const Pair& pair : pairs_of(bodies)) deepest = std::max(deepest, probe.depth(pair).value_or(0));
  return deepest;
}

template <int D>
double distance_of_runs(std::span<const Body<D>> bodies, std::span<const Vector<D>> others) {
  double sum = 0;
  double count = 0;
  for (std::size_t k = 0; k < std::min(bodies.size(), others.size()); ++k) {
    if (bodies[k].mobility == Mobility::fixed) continue;
    sum += distance_squared(bodies[k].pose.position, others[k]);
    ++count;
  }
  return count > 0 ? std::sqrt(sum / count) : 0;
}

template double size_of<2>(const Shape<2>&);
template double size_of<3>(const Shape<3>&);
template double energy_height<2>(std::span<const Body<2>>, std::span<const Vector<2>>);
template double energy_height<3>(std::span<const Body<3>>, std::span<const Vector<3>>);
template double deepest_penetration<2>(std::span<const Body<2>>);
template double deepest_penetration<3>(std::span<const Body<3>>);
template double distance_of_runs<2>(std::span<const Body<2>>, std::span<const Vector<2>>);
template double distance_of_runs<3>(std::span<const Body<3>>, std::span<const Vector<3>>);

}  // namespace kerf
