#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "core/geometry/box.h"
#include "core/geometry/plane.h"
#include "core/geometry/vector.h"

namespace kerf {

/// How objects are bounded. A broad phase bounds all its objects in one way, chosen by the scene's needs.
enum class VolumeKind : std::uint8_t {
  box,           ///< the axis-aligned box itself
  sphere,        ///< disc in 2D
  oriented_box,  ///< box with axes of its own
  dop8,          ///< 2D: the axes and two diagonals
  dop16,         ///< 2D: eight slabs
  dop14,         ///< 3D: the axes and the four diagonals of the cube
  dop26,         ///< 3D: those and the six diagonals of its faces
};

/// Every kind that exists in D dimensions, the box first.
template <int D>
std::span<const VolumeKind> volume_kinds();
/// "box", "sphere", "oriented-box", "8-dop", "16-dop", "14-dop", "26-dop".
std::string_view to_string(VolumeKind kind);
/// The kind of that name, if it exists in D dimensions.
template <int D>
std::optional<VolumeKind> parse_volume_kind(std::string_view name);

/// The most numbers that a volume stores beside its box: the ends of ten slabs for the 26-DOP, of six for the
/// 16-DOP.
template <int D>
inline constexpr int kMaxExtra = D == 3 ? 20 : 12;

/// How far from orthonormal the axes of an oriented box may be.
inline constexpr double kAxisTolerance = 1e-5;

/// An object's volume: always its box, and the numbers of its kind. The functions below make one.
template <int D>
struct Volume {
  VolumeKind kind = VolumeKind::box;
  Box<D> box;
  /// sphere: centre, radius (infinite: all space). oriented_box: centre, axes, half extents. DOPs: lo, hi of
  /// each slab behind the axes.
  std::array<Scalar, kMaxExtra<D>> extra{};
};

/// How many numbers of `extra` the kind uses.
template <int D>
constexpr int extra_size(VolumeKind kind) {
  switch (kind) {
    case VolumeKind::box:
      return 0;
    case VolumeKind::sphere:
      return D + 1;
    case VolumeKind::oriented_box:
      return D + D * D + D;
    case VolumeKind::dop8:
      return 8 - 4;
    case VolumeKind::dop16:
      return 16 - 4;
    case VolumeKind::dop14:
      return 14 - 6;
    case VolumeKind::dop26:
      return 26 - 6;
  }
  return 0;
}

template <int D>
Volume<D> make_box_volume(const Box<D>& box);

template <int D>
Volume<D> make_sphere(const Vector<D>& center, Scalar radius);

/// `axes` are orthonormal within `kAxisTolerance`, `half` the half extents along them.
template <int D>
Volume<D> make_oriented_box(const Vector<D>& center, const std::array<Vector<D>, D>& axes,
                            const Vector<D>& half);

/// A DOP from its slabs, which are intervals along `slab_directions<D>(kind)`: the axes' first.
template <int D>
Volume<D> make_dop(VolumeKind kind, std::span<const Interval> slabs);

/// The smallest volume of a kind around a box, for callers that give only a box.
template <int D>
Volume<D> enclose(const Box<D>& box, VolumeKind kind);

/// Whether two volumes of one kind overlap, given that their boxes do. Never false for volumes that touch.
/// Exact for boxes and DOPs; the other kinds have a slack above all rounding. This is the definition of a
/// pair for that kind, in the tree and in the oracle alike. `a` and `b` point to the `extra` numbers of each.
template <int D>
bool volumes_overlap(VolumeKind kind, const Scalar* a, const Scalar* b);

/// Whether the numbers make a volume: no NaN, no inverted interval, no negative radius or half extent, no
/// skewed axes.
template <int D>
bool is_ordered(const Volume<D>& volume);

/// The volume with every infinite number replaced by the largest finite one of its sign, except a sphere's
/// radius.
template <int D>
Volume<D> clamp_to_finite(Volume<D> volume);

}  // namespace kerf
