#include "core/related/chosen_planes.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/direction_set.h"
#include "core/related/principal_axes.h"

namespace kerf {
namespace {

constexpr std::uint32_t kDirections = 256;  // enough for 2 sqrt(n) of 16,000 objects
constexpr std::uint64_t kSeed = 1;

/// The same for every tree, and made for the first node that is divided: in 2D they take some 20
/// milliseconds.
template <int D>
const DirectionSet<D>& fixed_directions() {
  static const DirectionSet<D> directions(kDirections, kSeed);
  return directions;
}

/// Of length one; an axis if there is no direction.
template <int D>
Vector<D> normalised(const std::array<double, D>& direction) {
  double square = 0;
  for (const double x : direction) square += x * x;
  Vector<D> result;
  result[0] = 1;
  if (!(square > 0)) return result;
  for (std::size_t i = 0; i < D; ++i)
    result.value[i] = static_cast<Scalar>(std::clamp(direction[i] / std::sqrt(square), -1.0, 1.0));
  return result;
}

template <int D>
Vector<D> drawn_direction(Random& random) {
  std::array<double, D> direction{};
  for (double& x : direction) x = random.uniform(-1, 1);
  return normalised<D>(direction);
}

}  // namespace

template <int D>
std::optional<Plane<D>> FixedDirections<D>::choose(std::span<const ObjectId> objects) {
  const auto wanted = static_cast<std::uint32_t>(2 * std::sqrt(static_cast<double>(objects.size())));
  const DirectionSet<D>& directions = fixed_directions<D>();
  std::optional<Plane<D>> best;
  double least = 0;
  for (std::uint32_t k = 0; k < std::min(wanted, directions.size()); ++k) {
    const Plane<D> plane = this->middle_plane(objects, directions[k]);
    const double cost = this->split(objects, plane).cost();
    if (best && cost >= least) continue;
    best = plane;
    least = cost;
  }
  return best;
}

template <int D>
std::optional<Plane<D>> PrincipalComponents<D>::choose(std::span<const ObjectId> objects) {
  std::vector<Vector<D>> centres;
  centres.reserve(objects.size());
  for (const ObjectId object : objects) centres.push_back(this->table().box(object).center());
  const PrincipalAxes<D> principal = principal_axes<D>(centres);
  for (const Vector<D>& axis : principal.axes) {
    const Plane<D> plane{axis, dot(axis, principal.mean)};
    if (this->pays(this->split(objects, plane), objects.size())) return plane;
  }
  return std::nullopt;
}

template <int D>
auto EvolvedPlanes<D>::individual(std::span<const ObjectId> objects, const Vector<D>& normal,
                                  Random& random) const -> Individual {
  const ObjectId through = objects[random.below(static_cast<std::uint32_t>(objects.size()))];
  const Plane<D> plane{normal, dot(normal, this->table().box(through).center())};
  return {plane, this->split(objects, plane).cost()};
}

template <int D>
auto EvolvedPlanes<D>::child(std::span<const ObjectId> objects, const std::vector<Individual>& parents,
                             Random& random) const -> Individual {
  constexpr auto kParents = static_cast<std::uint32_t>(kPopulation / 2);
  const Vector<D>& a = parents[random.below(kParents)].plane.normal;
  const Vector<D>& b = parents[random.below(kParents)].plane.normal;
  std::array<double, D> direction{};
  for (std::size_t i = 0; i < D; ++i)
    direction[i] = double{a.value[i]} + double{b.value[i]} + random.uniform(-kMutation, kMutation);
  return individual(objects, normalised<D>(direction), random);
}

template <int D>
std::optional<Plane<D>> EvolvedPlanes<D>::choose(std::span<const ObjectId> objects) {
  Random random(kSeed);
  std::vector<Individual> all;
  for (std::size_t k = 0; k < kPopulation; ++k)
    all.push_back(individual(objects, drawn_direction<D>(random), random));
  for (int generation = 0; generation < kGenerations; ++generation) {
    std::ranges::stable_sort(all, {}, &Individual::cost);
    for (std::size_t k = kPopulation / 2; k < kPopulation; ++k) all[k] = child(objects, all, random);
  }
  return std::ranges::min_element(all, {}, &Individual::cost)->plane;
}

template class FixedDirections<2>;
template class FixedDirections<3>;
template class PrincipalComponents<2>;
template class PrincipalComponents<3>;
template class EvolvedPlanes<2>;
template class EvolvedPlanes<3>;

}  // namespace kerf
