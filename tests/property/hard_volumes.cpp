#include "tests/property/hard_volumes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/property/turn.h"

namespace kerf::test {
namespace {

constexpr double kMax = std::numeric_limits<Scalar>::max();

Scalar to_scalar(double x) { return static_cast<Scalar>(std::clamp(x, -kMax, kMax)); }
Scalar above(Scalar x) { return std::nextafter(x, std::numeric_limits<Scalar>::max()); }
Scalar below(Scalar x) { return std::nextafter(x, std::numeric_limits<Scalar>::lowest()); }

double power_of_two(Random& random, int low, int high) {
  return std::ldexp(1.0, low + static_cast<int>(random.below(static_cast<std::uint32_t>(high - low + 1))));
}

Interval ordered(double a, double b) { return {to_scalar(std::min(a, b)), to_scalar(std::max(a, b))}; }

template <int D>
Vector<D> to_vector(const Precise<D>& p) {
  Vector<D> v;
  for (std::size_t i = 0; i < D; ++i) v.value[i] = to_scalar(p[i]);
  return v;
}

/// Half the shadow of an oriented box on a unit axis.
template <int D>
double reach(const std::array<Vector<D>, D>& axes, const Vector<D>& half, const Precise<D>& along) {
  double sum = 0;
  for (std::size_t k = 0; k < D; ++k)
    sum +=
        std::abs(inner<D>(to_precise<D>(axes[k].value.data()), along)) * static_cast<double>(half.value[k]);
  return sum;
}

}  // namespace

template <int D>
void HardVolumes<D>::begin_cluster() {
  cluster_.clear();
  lattice_ = random_.below(3) == 0;
  const std::uint32_t sort = random_.below(8);
  scale_ = sort == 0 ? power_of_two(random_, -149, -120) : power_of_two(random_, -20, 20);
  if (sort == 1) scale_ = power_of_two(random_, 120, 127);
  for (int i = 0; i < D; ++i) {
    // Up to 2^24 times the scale: there an ulp of the place is as large as an object.
    const double away = random_.below(3) == 0 ? 0 : scale_ * power_of_two(random_, 0, 24);
    place_[i] = to_scalar(random_.below(2) == 0 ? away : -away);
  }
}

template <int D>
Volume<D> HardVolumes<D>::next() {
  Volume<D> volume =
      cluster_.empty() ? first() : make(cluster_[random_.below(static_cast<std::uint32_t>(cluster_.size()))]);
  // Where a sum left the floats, a box that touches the earlier one does as well.
  if (!is_ordered(volume)) volume = first();
  cluster_.push_back(volume);
  return volume;
}

template <int D>
Volume<D> HardVolumes<D>::first() {
  Box<D> box;
  for (int i = 0; i < D; ++i) {
    const Interval interval = fresh(i);
    box.min[i] = interval.lo;
    box.max[i] = interval.hi;
  }
  return enclose<D>(box, kind_);
}

template <int D>
Volume<D> HardVolumes<D>::make(const Volume<D>& earlier) {
  if (random_.below(8) == 0) return enclose<D>(box_beside(earlier.box), kind_);
  switch (kind_) {
    case VolumeKind::box:
      return make_box_volume(box_beside(earlier.box));
    case VolumeKind::sphere:
      return sphere(earlier);
    case VolumeKind::oriented_box:
      return oriented_box(earlier);
    default:
      return dop(earlier);
  }
}

/// A length of the cluster's scale, of none, or of a far larger or smaller one.
template <int D>
double HardVolumes<D>::size() {
  switch (random_.below(6)) {
    case 0:
      return 0;
    case 1:
      return scale_ * power_of_two(random_, -30, 30);
    case 2:
      return scale_;
    default:
      return lattice_ ? scale_ * random_.below(4) : scale_ * random_.unit();
  }
}

/// What a distance at which two volumes touch is multiplied by.
template <int D>
double HardVolumes<D>::nearly_one() {
  constexpr std::array kOff{0.0, 0.0, -0x1p-24, 0x1p-24, -0x1p-22, 0x1p-22, -0x1p-44, 0x1p-50};
  return random_.below(4) == 0 ? random_.unit() : 1 + kOff[random_.below(kOff.size())];
}

template <int D>
Interval HardVolumes<D>::fresh(int axis) {
  double center = scale_ * random_.uniform(-1, 1);
  if (lattice_) center = scale_ * std::round(center / scale_ * 2) / 2;
  const double half = size();
  center += static_cast<double>(place_[axis]);
  return ordered(center - half, center + half);
}

template <int D>
Interval HardVolumes<D>::from_end(Scalar end, bool upward) {
  const double other = static_cast<double>(end) + (upward ? 2 : -2) * size();
  return upward ? Interval{end, std::max(end, to_scalar(other))}
                : Interval{std::min(end, to_scalar(other)), end};
}

template <int D>
Interval HardVolumes<D>::beside(const Interval& earlier) {
  const double middle = static_cast<double>(earlier.lo) / 2 + static_cast<double>(earlier.hi) / 2;
  switch (random_.below(24)) {
    case 0:  // misses by an ulp
      return from_end(above(earlier.hi), true);
    case 1:
    case 2:
      return from_end(earlier.hi, true);
    case 3:
    case 4:
      return from_end(below(earlier.hi), true);
    case 5:
    case 6:
      return from_end(earlier.lo, false);
    case 7:
    case 8:
      return from_end(above(earlier.lo), false);
    case 9:
    case 10:
      return earlier;
    case 11:
      return {earlier.lo, earlier.lo};
    case 12:
      return {earlier.hi, earlier.hi};
    case 13:
      return {to_scalar(middle), to_scalar(middle)};
    case 14:  // differs in the sign of zero or holds the earlier one
      return {-earlier.hi == earlier.lo ? -earlier.hi : earlier.lo, above(earlier.hi)};
    default: {
      const double half = size();
      return ordered(middle - half, middle + half);
    }
  }
}

template <int D>
Box<D> HardVolumes<D>::box_beside(const Box<D>& earlier) {
  Box<D> box;
  for (int i = 0; i < D; ++i) {
    const Interval interval = beside({earlier.min[i], earlier.max[i]});
    box.min[i] = interval.lo;
    box.max[i] = interval.hi;
  }
  return box;
}

template <int D>
Volume<D> HardVolumes<D>::sphere(const Volume<D>& earlier) {
  const auto center = to_precise<D>(earlier.extra.data());
  const double radius = std::min(static_cast<double>(earlier.extra[D]), kMax);
  double mine = random_.below(4) == 0 ? radius : size();
  const double distance = (radius + mine) * nearly_one();
  const Precise<D> along = random_unit<D>(random_);
  Precise<D> there;
  for (std::size_t i = 0; i < D; ++i) there[i] = center[i] + along[i] * distance;
  const Vector<D> place = to_vector<D>(there);
  // The float centre is a little off: the radius makes good for it, to the ulp.
  double apart = 0;
  for (std::size_t i = 0; i < D; ++i) apart += std::pow(static_cast<double>(place.value[i]) - center[i], 2);
  const double needed = std::sqrt(apart) - radius;
  if (needed >= 0 && random_.below(2) == 0) mine = needed;
  Scalar rounded = random_.below(2) == 0 ? round_up(mine) : round_down(mine);
  if (random_.below(64) == 0) rounded = std::numeric_limits<Scalar>::infinity();
  return make_sphere<D>(place, rounded);
}

template <int D>
std::array<Vector<D>, D> HardVolumes<D>::axes_near(const std::array<Vector<D>, D>& earlier) {
  const std::uint32_t sort = random_.below(4);
  std::array<Vector<D>, D> axes = sort == 0 ? identity_axes<D>() : earlier;
  if (sort == 1) axes = turned<D>(axes, std::pow(10, random_.uniform(-9, -1)), random_);
  if (sort == 2) axes = turned<D>(axes, random_.uniform(0, 7), random_);
  if (random_.below(4) != 0) return axes;
  std::array<Vector<D>, D> skewed = axes;  // by less than kAxisTolerance
  for (Vector<D>& axis : skewed)
    for (int i = 0; i < D; ++i) axis[i] += static_cast<Scalar>(random_.uniform(-2.5e-6, 2.5e-6));
  return is_ordered(make_oriented_box<D>({}, skewed, {})) ? skewed : axes;
}

template <int D>
Volume<D> HardVolumes<D>::oriented_box(const Volume<D>& earlier) {
  std::array<Vector<D>, D> old_axes;
  Vector<D> old_half;
  for (std::size_t k = 0; k < D; ++k) {
    for (std::size_t i = 0; i < D; ++i) old_axes[k].value[i] = earlier.extra[D + k * D + i];
    old_half.value[k] = earlier.extra[D + D * D + k];
  }
  const std::array<Vector<D>, D> axes = axes_near(old_axes);
  Vector<D> half;
  for (int k = 0; k < D; ++k) half[k] = random_.below(4) == 0 ? old_half[k] : to_scalar(size());

  // Touching along a face normal of either, the cross product of two edges, or anything else.
  Precise<D> along = separating_axis<D>(old_axes, axes, random_);
  const double distance = (reach<D>(old_axes, old_half, along) + reach<D>(axes, half, along)) * nearly_one();
  auto center = to_precise<D>(earlier.extra.data());
  for (std::size_t i = 0; i < D; ++i) center[i] += along[i] * distance;
  // Sliding along the faces keeps the distance.
  const Precise<D> slide = random_unit<D>(random_);
  const double off = inner<D>(slide, along);
  const double far = random_.below(2) == 0 ? 0 : size();
  for (std::size_t i = 0; i < D; ++i) center[i] += (slide[i] - off * along[i]) * far;
  return make_oriented_box<D>(to_vector<D>(center), axes, half);
}

template <int D>
Volume<D> HardVolumes<D>::dop(const Volume<D>& earlier) {
  std::vector<Interval> slabs;
  const std::size_t count = slab_directions<D>(kind_).size();
  if (random_.below(2) == 0) {  // each slab on its own: the rule concerns slabs, not bodies
    const bool calm = random_.below(4) != 0;
    for (std::size_t k = 0; k < count; ++k) {
      const Scalar* ends = earlier.extra.data() + 2 * (k - std::min<std::size_t>(k, D));
      const int axis = static_cast<int>(std::min<std::size_t>(k, D - 1));
      const Interval old =
          k < D ? Interval{earlier.box.min[axis], earlier.box.max[axis]} : Interval{ends[0], ends[1]};
      slabs.push_back(calm && random_.below(static_cast<std::uint32_t>(count)) > 1 ? old : beside(old));
    }
    return make_dop<D>(kind_, slabs);
  }
  std::array<Precise<D>, 4> points;
  const Box<D> box = box_beside(earlier.box);
  for (Precise<D>& point : points)
    for (std::size_t i = 0; i < D; ++i)
      point[i] = static_cast<double>(random_.below(2) == 0 ? box.min.value[i] : box.max.value[i]);
  for (const Vector<D>& slab : slab_directions<D>(kind_)) {
    const auto direction = to_precise<D>(slab.value.data());
    double lo = inner<D>(direction, points[0]);
    double hi = lo;
    for (const Precise<D>& point : points) {
      lo = std::min(lo, inner<D>(direction, point));
      hi = std::max(hi, inner<D>(direction, point));
    }
    slabs.push_back({round_down(lo), round_up(hi)});
  }
  return make_dop<D>(kind_, slabs);
}

template <int D>
std::vector<Vector<D>> hard_directions(std::uint32_t count, Random& random) {
  constexpr std::array<Scalar, 6> kTiny{1e-45F, 1e-38F, 1e-20F, 0x1p-25F, 0x1p-12F, 1e-3F};
  std::vector<Vector<D>> directions;
  while (directions.size() < count) {
    Vector<D> direction = to_vector<D>(random_unit<D>(random));
    const auto axis = static_cast<int>(random.below(D));
    switch (random.below(6)) {
      case 0:  // nearly along an axis
        for (int i = 0; i < D; ++i) direction[i] = kTiny[random.below(kTiny.size())];
        direction[axis] = random.below(2) == 0 ? 1.0F : std::nextafter(1.0F, 0.0F);
        break;
      case 1:  // short
        for (int i = 0; i < D; ++i) direction[i] *= kTiny[3 + random.below(3)];
        break;
      case 2:  // diagonal and longer than one
        for (int i = 0; i < D; ++i) direction[i] = random.below(2) == 0 ? 1.0F : -1.0F;
        break;
      case 3:
        if (!directions.empty()) direction = directions.back();
        break;
      default:
        break;
    }
    if (direction != Vector<D>{}) directions.push_back(direction);
  }
  return directions;
}

template class HardVolumes<2>;
template class HardVolumes<3>;
template std::vector<Vector<2>> hard_directions<2>(std::uint32_t, Random&);
template std::vector<Vector<3>> hard_directions<3>(std::uint32_t, Random&);

}  // namespace kerf::test
