#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/geometry/volume.h"

namespace kerf {

/// The candidates that a kind of volume leaves for each true contact, and their price.
struct VolumeFigure {
  int dimension = 3;
  double slenderness = 1;  ///< length over thickness of the bricks
  VolumeKind kind = VolumeKind::box;
  std::uint64_t candidates = 0;
  std::uint64_t contacts =
      0;                     ///< by an exact test of the bricks: ODE's in 3D, separating axes in double in 2D
  std::uint64_t missed = 0;  ///< contacts that are no candidates; must be 0
  double bound_ns = 0;       ///< an object and step, on average: to bound the bricks
  /// Of processor time of our tree, for an object and step in which everything drifts and turns.
  double mean_ns = 0;
  double median_ns = 0;
  double p99_ns = 0;
  double max_ns = 0;
  double low_ns = 0;   ///< mean of the fastest round
  double high_ns = 0;  ///< and of the slowest
};

/// The slendernesses to measure: cubes, short and long rods.
std::vector<double> slendernesses();

/// Bricks of unit volume, length over thickness `slenderness`, at random poses and as dense as a pile, for
/// each kind of volume of the dimension. Calls `poll`, if there is one, once a step.
std::vector<VolumeFigure> measure_volumes(int dimension, double slenderness, std::uint32_t bricks,
                                          const std::function<void()>& poll = {});

}  // namespace kerf
