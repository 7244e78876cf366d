#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/geometry/slabs.h"
#include "core/geometry/volume.h"

namespace kerf::test {

/// A change of coordinates that loses no bit: axes permuted, some of them mirrored, all scaled by a power of
/// two.
template <int D>
struct Symmetry {
  std::array<int, D> from;     ///< new axis i is old axis from[i]
  std::array<bool, D> flip{};  ///< new axis i is mirrored
  int exponent = 0;

  static Symmetry none() {
    Symmetry s;
    for (int i = 0; i < D; ++i) s.from[static_cast<std::size_t>(i)] = i;
    return s;
  }

  [[nodiscard]] Scalar scaled(Scalar x) const { return std::ldexp(x, exponent); }
  /// Of a direction: it is not scaled.
  [[nodiscard]] Vector<D> turned(const Vector<D>& v) const {
    Vector<D> result;
    for (std::size_t i = 0; i < D; ++i) result.value[i] = flip[i] ? -v[from[i]] : v[from[i]];
    return result;
  }
  [[nodiscard]] Vector<D> applied(const Vector<D>& point) const {
    Vector<D> result = turned(point);
    for (Scalar& x : result.value) x = scaled(x);
    return result;
  }
  [[nodiscard]] Box<D> applied(const Box<D>& box) const {
    const Vector<D> a = applied(box.min);
    const Vector<D> b = applied(box.max);
    Box<D> result;
    for (int i = 0; i < D; ++i) {
      result.min[i] = std::min(a[i], b[i]);
      result.max[i] = std::max(a[i], b[i]);
    }
    return result;
  }
  [[nodiscard]] Volume<D> applied(const Volume<D>& volume) const;
};

namespace detail {

template <int D>
Vector<D> vector_at(const Volume<D>& volume, int at) {
  Vector<D> v;
  for (int i = 0; i < D; ++i) v[i] = volume.extra[static_cast<std::size_t>(at + i)];
  return v;
}

template <int D>
Volume<D> changed_oriented_box(const Symmetry<D>& s, const Volume<D>& volume) {
  std::array<Vector<D>, D> axes;
  for (int k = 0; k < D; ++k) axes[static_cast<std::size_t>(k)] = s.turned(vector_at(volume, D + k * D));
  Vector<D> half = vector_at(volume, D + D * D);
  for (Scalar& x : half.value) x = s.scaled(x);
  return make_oriented_box<D>(s.applied(vector_at(volume, 0)), axes, half);
}

/// Slab directions go over into slab directions or into their opposites.
template <int D>
Volume<D> changed_dop(const Symmetry<D>& s, const Volume<D>& volume) {
  const auto directions = slab_directions<D>(volume.kind);
  std::vector<Interval> slabs(directions.size());
  for (std::size_t k = 0; k < directions.size(); ++k) {
    const int axis = static_cast<int>(std::min<std::size_t>(k, D - 1));
    const std::size_t at = k < D ? 0 : 2 * (k - D);
    const Interval old = k < D ? Interval{volume.box.min[axis], volume.box.max[axis]}
                               : Interval{volume.extra[at], volume.extra[at + 1]};
    const Vector<D> image = s.turned(directions[k]);
    for (std::size_t j = 0; j < directions.size(); ++j) {
      if (directions[j] == image) slabs[j] = {s.scaled(old.lo), s.scaled(old.hi)};
      if (directions[j] == image * -1) slabs[j] = {s.scaled(-old.hi), s.scaled(-old.lo)};
    }
  }
  return make_dop<D>(volume.kind, slabs);
}

}  // namespace detail

template <int D>
Volume<D> Symmetry<D>::applied(const Volume<D>& volume) const {
  Volume<D> result = volume;
  if (volume.kind == VolumeKind::sphere)
    result = make_sphere<D>(applied(detail::vector_at(volume, 0)), scaled(volume.extra[D]));
  else if (volume.kind == VolumeKind::oriented_box)
    result = detail::changed_oriented_box(*this, volume);
  else if (volume.kind != VolumeKind::box)
    result = detail::changed_dop(*this, volume);
  result.box = applied(volume.box);
  return result;
}

}  // namespace kerf::test
