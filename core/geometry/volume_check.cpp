#include <algorithm>
#include <cmath>
#include <limits>

#include "core/geometry/volume.h"

namespace kerf {
namespace {

template <int D>
bool axes_are_orthonormal(const Scalar* axes) {
  bool all = true;
  for (int i = 0; i < D; ++i) {
    for (int j = i; j < D; ++j) {
      double product = 0;
      for (int k = 0; k < D; ++k)
        product += static_cast<double>(axes[i * D + k]) * static_cast<double>(axes[j * D + k]);
      all &= std::abs(product - (i == j ? 1 : 0)) <= kAxisTolerance;
    }
  }
  return all;
}

/// Whether the kind's own numbers make a volume: radius, half extents or slabs. NaN is checked elsewhere.
template <int D>
bool extra_is_ordered(const Volume<D>& volume) {
  const auto& x = volume.extra;
  if (volume.kind == VolumeKind::sphere) return x[D] >= 0;
  if (volume.kind == VolumeKind::oriented_box)
    return axes_are_orthonormal<D>(x.data() + D) &&
           std::all_of(x.begin() + D + D * D, x.begin() + extra_size<D>(volume.kind),
                       [](Scalar h) { return h >= 0; });
  bool all = true;
  for (std::size_t i = 0; i < static_cast<std::size_t>(extra_size<D>(volume.kind)); i += 2)
    all &= x[i] <= x[i + 1];
  return all;
}

void clamp_to_finite(Scalar& x) {
  x = std::clamp(x, std::numeric_limits<Scalar>::lowest(), std::numeric_limits<Scalar>::max());
}

}  // namespace

template <int D>
bool is_ordered(const Volume<D>& volume) {
  bool all = true;
  for (int i = 0; i < D; ++i) all &= volume.box.min[i] <= volume.box.max[i];  // false for NaN
  const auto size = static_cast<std::size_t>(extra_size<D>(volume.kind));
  for (std::size_t i = 0; i < size; ++i) all &= !std::isnan(volume.extra[i]);
  return all && extra_is_ordered(volume);
}

template <int D>
Volume<D> clamp_to_finite(Volume<D> volume) {
  for (int i = 0; i < D; ++i) {
    clamp_to_finite(volume.box.min[i]);
    clamp_to_finite(volume.box.max[i]);
  }
  const bool sphere = volume.kind == VolumeKind::sphere;
  const auto size = static_cast<std::size_t>(sphere ? D : extra_size<D>(volume.kind));
  for (std::size_t i = 0; i < size; ++i) clamp_to_finite(volume.extra[i]);
  return volume;
}

template bool is_ordered<2>(const Volume<2>&);
template bool is_ordered<3>(const Volume<3>&);
template Volume<2> clamp_to_finite<2>(Volume<2>);
template Volume<3> clamp_to_finite<3>(Volume<3>);

}  // namespace kerf
