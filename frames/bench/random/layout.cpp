#include "frames/bench/random/layout.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "frames/bench/motion.h"
#include "frames/bench/truth.h"

namespace kerf {
namespace {

/// The thickness of lines, sheets and rings in a world of side 1.
constexpr double kThickness = 0.01;

template <int D>
Place<D> anywhere(Random& random) {
  Place<D> place;
  for (double& x : place) x = random.unit();
  return place;
}

/// The sum of four uniform numbers: a bell as wide as its standard deviation says, with bounded ends.
double bell(Random& random, double deviation) {
  double sum = -2;
  for (int k = 0; k < 4; ++k) sum += random.unit();
  return sum * deviation * std::numbers::sqrt3;
}

/// Makes the places of a layout, one after another, in a world of side 1.
template <int D>
class Placer {
 public:
  Placer(Scattering layout, std::uint32_t count, Random& random)
      : layout_(layout), random_(random), cells_(grid_cells(count)) {
    constexpr std::uint32_t kInCluster = 200;
    for (std::uint32_t k = 0; k <= count / kInCluster; ++k) middles_.push_back(anywhere<D>(random));
  }

  Place<D> place(std::uint32_t k) {
    switch (layout_) {
      case Scattering::clusters:
        return in_cluster();
      case Scattering::line:
        return flat(1);
      case Scattering::sheet:
        return flat(D - 1);
      case Scattering::ring:
        return on_ring();
      case Scattering::slanted_line:
        return along_diagonal();
      case Scattering::slanted_sheet:
        return on_slope();
      case Scattering::turned_grid:
        return on_grid(k);
      case Scattering::uniform:
        break;
    }
    return anywhere<D>(random_);
  }

 private:
  static std::uint32_t grid_cells(std::uint32_t count) {
    return static_cast<std::uint32_t>(std::ceil(std::pow(count, 1.0 / D)));
  }
  Place<D> in_cluster() {
    constexpr double kDeviation = 0.02;
    Place<D> place = middles_[random_.below(static_cast<std::uint32_t>(middles_.size()))];
    for (double& x : place) x += bell(random_, kDeviation);
    return place;
  }
  /// Thin in all axes but the first `extended` ones.
  Place<D> flat(int extended) {
    Place<D> place = anywhere<D>(random_);
    for (auto axis = static_cast<std::size_t>(extended); axis < D; ++axis)
      place[axis] = 0.5 + (place[axis] - 0.5) * kThickness;
    return place;
  }
  Place<D> on_ring() {
    Place<D> place;
    place.fill(0.5);
    const double angle = random_.uniform(0, 2 * std::numbers::pi);
    place[0] += 0.45 * std::cos(angle);
    place[1] += 0.45 * std::sin(angle);
    for (double& x : place) x += random_.uniform(-kThickness, kThickness) / 2;
    return place;
  }
  Place<D> along_diagonal() {
    Place<D> place;
    place.fill(random_.unit());
    for (double& x : place) x += random_.uniform(-kThickness, kThickness) / 2;
    return place;
  }
  /// The last axis follows the others.
  Place<D> on_slope() {
    Place<D> place = anywhere<D>(random_);
    double height = 0;
    for (std::size_t axis = 0; axis + 1 < D; ++axis) height += place[axis] * (axis == 0 ? 0.6 : 0.3);
    place[D - 1] = height + place[D - 1] * kThickness;
    return place;
  }
  /// Turned by half a radian in the plane of the first two axes, a little uneven.
  Place<D> on_grid(std::uint32_t k) {
    constexpr double kAngle = 0.5;
    Place<D> place;
    for (double& x : place) {
      x = (k % cells_ + 0.5 + random_.uniform(-0.1, 0.1)) / cells_;
      k /= cells_;
    }
    const double x = place[0] - 0.5;
    const double y = place[1] - 0.5;
    place[0] = 0.5 + x * std::cos(kAngle) - y * std::sin(kAngle);
    place[1] = 0.5 + x * std::sin(kAngle) + y * std::cos(kAngle);
    return place;
  }

  Scattering layout_;
  Random& random_;
  std::uint32_t cells_;
  std::vector<Place<D>> middles_;
};

template <int D>
Place<D> half_extents(const RandomScene& scene, Random& random) {
  const double size = scene.decades > 0 ? std::pow(10, -scene.decades * random.unit()) : 1;
  Place<D> half;
  for (double& x : half) x = size * random.uniform(0.25, 0.75);
  const std::size_t axis = random.below(D);
  if (scene.shapes == BoxShapes::plates) half[axis] /= scene.aspect;
  for (std::size_t i = 0; i < D; ++i)
    if (scene.shapes == BoxShapes::rods && i != axis) half[i] /= scene.aspect;
  return half;
}

template <int D>
double usual_extent(const std::vector<Place<D>>& halves) {
  std::vector<double> sizes;
  for (const Place<D>& half : halves) {
    double sum = 0;
    for (const double x : half) sum += 2 * x;
    sizes.push_back(sum / D);
  }
  std::ranges::nth_element(sizes, sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2));
  return sizes[sizes.size() / 2];
}

/// Pairs an object of the first `count` in a world of that side: never fewer in a smaller one.
template <int D>
double density_at(double side, const LaidOut<D>& unit, std::uint32_t count) {
  std::vector<Box<D>> boxes;
  for (std::uint32_t k = 0; k < count; ++k) {
    Place<D> center = unit.centers[k];
    for (double& x : center) x *= side;
    boxes.push_back(box_at<D>(center, unit.halves[k]));
  }
  return static_cast<double>(true_pairs<D>(boxes, count).size()) / count;
}

/// The side at which places of a world of side 1 have that density, from large sides on, since at a much too
/// small one everything would be a pair.
template <int D>
double side_of_density(const LaidOut<D>& unit, std::uint32_t count, double density) {
  constexpr double kShrink = 0.75;
  constexpr int kHalvings = 24;
  double high = 64 * side_for(count, D, unit.size, density);
  while (density_at(high, unit, count) > density) high *= 4;
  double low = high * kShrink;
  while (density_at(low, unit, count) < density) {
    high = low;
    low *= kShrink;
  }
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = std::sqrt(low * high);
    const double found = density_at(middle, unit, count);
    if (std::abs(found / density - 1) <= kDensityTolerance) return middle;
    (found > density ? low : high) = middle;
  }
  return low;
}

}  // namespace

template <int D>
LaidOut<D> lay_out(const RandomScene& scene, std::uint32_t count, Random& random) {
  LaidOut<D> laid;
  Placer<D> placer(scene.layout, count, random);
  for (std::uint32_t k = 0; k < count; ++k) {
    laid.centers.push_back(placer.place(k));
    laid.halves.push_back(half_extents<D>(scene, random));
  }
  laid.size = usual_extent<D>(laid.halves);
  laid.side = side_of_density(laid, scene.objects, scene.density);
  for (Place<D>& center : laid.centers)
    for (double& x : center) x *= laid.side;
  return laid;
}

template LaidOut<2> lay_out(const RandomScene&, std::uint32_t, Random&);
template LaidOut<3> lay_out(const RandomScene&, std::uint32_t, Random&);

}  // namespace kerf
