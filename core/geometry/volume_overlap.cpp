#include <cmath>

#include "core/geometry/precise.h"
#include "core/geometry/volume.h"

namespace kerf {
namespace {

// All of this is in double on float input: products of two floats are exact, and the few sums lose far less
// than the slack that every test grants. A test may only err towards "overlap".
constexpr double kRoundingSlack = 0x1p-44;

template <int D>
bool spheres_overlap(const Scalar* a, const Scalar* b) {
  double distance2 = 0;
  for (int i = 0; i < D; ++i) {
    const double apart = static_cast<double>(a[i]) - static_cast<double>(b[i]);
    distance2 += apart * apart;
  }
  const double reach = static_cast<double>(a[D]) + static_cast<double>(b[D]);
  return distance2 <= reach * reach * (1 + kRoundingSlack);
}

template <int D>
struct OrientedBox {
  explicit OrientedBox(const Scalar* p) : center(to_precise<D>(p)), half(to_precise<D>(p + D + D * D)) {
    for (std::size_t k = 0; k < D; ++k) axes[k] = to_precise<D>(p + D + static_cast<int>(k) * D);
  }
  Precise<D> center;
  std::array<Precise<D>, D> axes;
  Precise<D> half;
};

/// Half the length of the projection of the box on an axis that need not have length one.
template <int D>
double reach(const OrientedBox<D>& box, const Precise<D>& axis) {
  double sum = 0;
  for (std::size_t k = 0; k < D; ++k) sum += box.half[k] * std::abs(inner<D>(box.axes[k], axis));
  return sum;
}

/// True only if the axis separates by more than all roundings together. `size` bounds every length involved.
template <int D>
bool separates(const Precise<D>& axis, const OrientedBox<D>& a, const OrientedBox<D>& b,
               const Precise<D>& apart, double size) {
  double axis_size = 0;
  for (const double x : axis) axis_size += std::abs(x);
  const double gap = std::abs(inner<D>(axis, apart)) - (reach<D>(a, axis) + reach<D>(b, axis));
  return gap > kRoundingSlack * axis_size * size;
}

bool edges_separate(const OrientedBox<2>&, const OrientedBox<2>&, const Precise<2>&, double) { return false; }

bool edges_separate(const OrientedBox<3>& a, const OrientedBox<3>& b, const Precise<3>& apart, double size) {
  for (const Precise<3>& u : a.axes) {
    for (const Precise<3>& v : b.axes) {
      // Each component is the difference of two exact products, so it is right however nearly parallel the
      // edges are.
      const Precise<3> axis{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
      if (separates<3>(axis, a, b, apart, size)) return true;
    }
  }
  return false;
}

/// Separating axes: the faces of both and, in 3D, the cross products of their edges (Gottschalk et al. 1996).
template <int D>
bool oriented_boxes_overlap(const Scalar* pa, const Scalar* pb) {
  const OrientedBox<D> a(pa);
  const OrientedBox<D> b(pb);
  Precise<D> apart;
  double size = 0;
  for (std::size_t i = 0; i < D; ++i) {
    apart[i] = b.center[i] - a.center[i];
    size += std::abs(apart[i]) + a.half[i] + b.half[i];
  }
  for (const Precise<D>& axis : a.axes)
    if (separates<D>(axis, a, b, apart, size)) return false;
  for (const Precise<D>& axis : b.axes)
    if (separates<D>(axis, a, b, apart, size)) return false;
  return !edges_separate(a, b, apart, size);
}

/// The slabs are floats; comparing them needs no slack.
bool slabs_overlap(const Scalar* a, const Scalar* b, int numbers) {
  bool all = true;
  for (int i = 0; i < numbers; i += 2) all &= (a[i] <= b[i + 1]) & (b[i] <= a[i + 1]);
  return all;
}

}  // namespace

template <int D>
bool volumes_overlap(VolumeKind kind, const Scalar* a, const Scalar* b) {
  switch (kind) {
    case VolumeKind::box:
      return true;
    case VolumeKind::sphere:
      return spheres_overlap<D>(a, b);
    case VolumeKind::oriented_box:
      return oriented_boxes_overlap<D>(a, b);
    default:
      return slabs_overlap(a, b, extra_size<D>(kind));
  }
}

template bool volumes_overlap<2>(VolumeKind, const Scalar*, const Scalar*);
template bool volumes_overlap<3>(VolumeKind, const Scalar*, const Scalar*);

}  // namespace kerf
