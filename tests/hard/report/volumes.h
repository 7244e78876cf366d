#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/geometry/volume.h"

namespace kerf::test {

/// How many candidates a kind of volume leaves for each true contact.
struct VolumeFigure {
  int dimension = 3;
  double slenderness = 1;  ///< length over thickness of the bricks
  VolumeKind kind = VolumeKind::box;
  std::uint64_t candidates = 0;
  std::uint64_t contacts =
      0;                     ///< by an exact test of the bricks: ODE's in 3D, separating axes in double in 2D
  std::uint64_t missed = 0;  ///< contacts that are no candidates; must be 0
  double milliseconds = 0;   ///< of processor time for a step of our tree in which everything moves
};

/// Bricks of unit volume, 1:1, 4:1 and 16:1, at random poses and as dense as a pile, in both dimensions and
/// for each kind of volume.
std::vector<VolumeFigure> measure_volumes(std::uint32_t bricks);

}  // namespace kerf::test
