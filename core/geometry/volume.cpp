#include "core/geometry/volume.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/geometry/slabs.h"

namespace kerf {
namespace {

constexpr std::array kKinds2{VolumeKind::box, VolumeKind::sphere, VolumeKind::oriented_box, VolumeKind::dop8,
                             VolumeKind::dop16};
constexpr std::array kKinds3{VolumeKind::box, VolumeKind::sphere, VolumeKind::oriented_box, VolumeKind::dop14,
                             VolumeKind::dop26};

/// The box from center - reach to center + reach, rounded outward.
template <int D>
Box<D> box_around(const Vector<D>& center, const std::array<double, D>& reach) {
  Box<D> box;
  for (int i = 0; i < D; ++i) {
    box.min[i] = round_down(static_cast<double>(center[i]) - reach[static_cast<std::size_t>(i)]);
    box.max[i] = round_up(static_cast<double>(center[i]) + reach[static_cast<std::size_t>(i)]);
  }
  return box;
}

/// The extent of a box along a slab. It is monotone in each bound, so boxes that overlap have extents that
/// overlap.
template <int D>
Interval slab_of(const Box<D>& box, const Vector<D>& slab) {
  double lo = 0;
  double hi = 0;
  for (int i = 0; i < D; ++i) {
    const double s = static_cast<double>(slab[i]);
    lo += s * static_cast<double>(s < 0 ? box.max[i] : box.min[i]);
    hi += s * static_cast<double>(s < 0 ? box.min[i] : box.max[i]);
  }
  return {round_down(lo), round_up(hi)};
}

/// A float radius that is surely not below r. Beyond the floats it is infinite: such a sphere holds all
/// space.
Scalar radius_above(double r) {
  const double wide = r * (1 + 0x1p-50);
  constexpr Scalar kMax = std::numeric_limits<Scalar>::max();
  return wide > static_cast<double>(kMax) ? std::numeric_limits<Scalar>::infinity() : round_up(wide);
}

}  // namespace

template <>
std::span<const VolumeKind> volume_kinds<2>() {
  return kKinds2;
}

template <>
std::span<const VolumeKind> volume_kinds<3>() {
  return kKinds3;
}

std::string_view to_string(VolumeKind kind) {
  switch (kind) {
    case VolumeKind::box:
      return "box";
    case VolumeKind::sphere:
      return "sphere";
    case VolumeKind::oriented_box:
      return "oriented-box";
    case VolumeKind::dop8:
      return "8-dop";
    case VolumeKind::dop16:
      return "16-dop";
    case VolumeKind::dop14:
      return "14-dop";
    case VolumeKind::dop26:
      return "26-dop";
  }
  return "";
}

template <int D>
std::optional<VolumeKind> parse_volume_kind(std::string_view name) {
  for (const VolumeKind kind : volume_kinds<D>())
    if (to_string(kind) == name) return kind;
  return std::nullopt;
}

template <int D>
Volume<D> make_box_volume(const Box<D>& box) {
  Volume<D> volume;
  volume.box = box;
  return volume;
}

template <int D>
Volume<D> make_sphere(const Vector<D>& center, Scalar radius) {
  Volume<D> volume;
  volume.kind = VolumeKind::sphere;
  std::array<double, D> reach;
  reach.fill(static_cast<double>(radius));
  volume.box = box_around<D>(center, reach);
  std::copy(center.value.begin(), center.value.end(), volume.extra.begin());
  volume.extra[D] = radius;
  return volume;
}

template <int D>
Volume<D> make_oriented_box(const Vector<D>& center, const std::array<Vector<D>, D>& axes,
                            const Vector<D>& half) {
  Volume<D> volume;
  volume.kind = VolumeKind::oriented_box;
  std::array<double, D> reach{};
  for (std::size_t k = 0; k < D; ++k)
    for (std::size_t i = 0; i < D; ++i)
      reach[i] += std::abs(static_cast<double>(axes[k].value[i])) * static_cast<double>(half.value[k]);
  // Four roundings of doubles at most; a hair more than they can lose.
  for (double& r : reach) r *= 1 + 0x1p-50;
  volume.box = box_around<D>(center, reach);
  auto out = std::copy(center.value.begin(), center.value.end(), volume.extra.begin());
  for (const Vector<D>& axis : axes) out = std::copy(axis.value.begin(), axis.value.end(), out);
  std::copy(half.value.begin(), half.value.end(), out);
  return volume;
}

template <int D>
Volume<D> make_dop(VolumeKind kind, std::span<const Interval> slabs) {
  Volume<D> volume;
  volume.kind = kind;
  for (int i = 0; i < D; ++i) {
    volume.box.min[i] = slabs[static_cast<std::size_t>(i)].lo;
    volume.box.max[i] = slabs[static_cast<std::size_t>(i)].hi;
  }
  std::size_t next = 0;
  for (const Interval& slab : slabs.subspan(D)) {
    volume.extra[next++] = slab.lo;
    volume.extra[next++] = slab.hi;
  }
  return volume;
}

template <int D>
Volume<D> enclose(const Box<D>& box, VolumeKind kind) {
  const Vector<D> center = box.center();
  Vector<D> half;
  double radius2 = 0;
  for (int i = 0; i < D; ++i) {
    const double c = static_cast<double>(center[i]);
    half[i] = round_up(std::max(static_cast<double>(box.max[i]) - c, c - static_cast<double>(box.min[i])));
    radius2 += static_cast<double>(half[i]) * static_cast<double>(half[i]);
  }
  Volume<D> volume = make_box_volume(box);
  if (kind == VolumeKind::sphere) volume = make_sphere<D>(center, radius_above(std::sqrt(radius2)));
  if (kind == VolumeKind::oriented_box) volume = make_oriented_box<D>(center, identity_axes<D>(), half);
  if (extra_size<D>(kind) > 0 && volume.kind == VolumeKind::box) {
    std::vector<Interval> slabs;
    for (const Vector<D>& slab : slab_directions<D>(kind)) slabs.push_back(slab_of(box, slab));
    volume = make_dop<D>(kind, slabs);
  }
  volume.box = box;  // the caller's box is tighter than the volume's own
  return volume;
}

#define KERF_INSTANTIATE(D)                                                                  \
  template std::optional<VolumeKind> parse_volume_kind<D>(std::string_view);                 \
  template Volume<D> make_box_volume<D>(const Box<D>&);                                      \
  template Volume<D> make_sphere<D>(const Vector<D>&, Scalar);                               \
  template Volume<D> make_oriented_box<D>(const Vector<D>&, const std::array<Vector<D>, D>&, \
                                          const Vector<D>&);                                 \
  template Volume<D> make_dop<D>(VolumeKind, std::span<const Interval>);                     \
  template Volume<D> enclose<D>(const Box<D>&, VolumeKind);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
