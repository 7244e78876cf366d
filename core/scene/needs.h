#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "core/base/config.h"
#include "core/geometry/volume.h"

namespace kerf {

/// What a scene needs of its broad phase; nothing else is paid for (DESIGN.md, "Model only what a scene
/// needs").
struct Needs {
  int dimension = 3;                                 ///< 2 or 3
  VolumeKind volume = VolumeKind::box;               ///< how objects are bounded
  bool fixed_objects = true;                         ///< some objects never move
  bool rotation = true;                              ///< bodies turn, so that boxes change shape
  bool free_directions = true;                       ///< partitioners in other than axis directions pay
  std::array<bool, 3> separating{true, true, true};  ///< axes along which objects are separated
  bool contacts = true;                              ///< the narrow phase runs
};

/// The paper's parameters without those that the scene does not need.
Config default_config(const Needs& needs);

/// One line for captions, manifests and `kerf scenes`.
std::string describe(const Needs& needs);

}  // namespace kerf
