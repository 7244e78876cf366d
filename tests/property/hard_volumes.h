#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/random.h"
#include "core/geometry/slabs.h"
#include "core/geometry/volume.h"

namespace kerf::test {

/// Volumes of one kind that are made to trouble a broad phase. They come in clusters: a place, near the
/// origin or so far out that an ulp is as large as an object, and a scale, from denormals to FLT_MAX. Each
/// volume is made from an earlier one of its cluster: it touches it exactly, laps over or misses it by an
/// ulp, coincides with it, holds it, is a point or plate on it, or is 2^30 times larger or smaller.
template <int D>
class HardVolumes {
 public:
  HardVolumes(VolumeKind kind, Random& random) : kind_(kind), random_(random) { begin_cluster(); }

  void begin_cluster();
  /// A volume that a broad phase accepts as it is, or clamps: nothing in it is NaN or inverted.
  Volume<D> next();

 private:
  struct Turned {
    std::array<Vector<D>, D> axes;
    Vector<D> half;
  };

  Volume<D> make(const Volume<D>& earlier);
  Volume<D> first();
  Volume<D> sphere(const Volume<D>& earlier);
  Volume<D> oriented_box(const Volume<D>& earlier);
  Volume<D> dop(const Volume<D>& earlier);
  Box<D> box_beside(const Box<D>& earlier);
  Interval fresh(int axis);
  Interval beside(const Interval& earlier);
  Interval from_end(Scalar end, bool upward);
  double size();
  double nearly_one();
  std::array<Vector<D>, D> axes_near(const std::array<Vector<D>, D>& earlier);

  VolumeKind kind_;
  Random& random_;
  std::vector<Volume<D>> cluster_;
  Vector<D> place_;
  double scale_ = 1;
  bool lattice_ = false;
};

/// Partitioner normals of all sorts: nearly along an axis (down to denormal components), not of length one,
/// diagonal, repeated, random.
template <int D>
std::vector<Vector<D>> hard_directions(std::uint32_t count, Random& random);

}  // namespace kerf::test
