#pragma once

#include <cstdint>
#include <vector>

#include "core/bsp/bsp_state.h"

namespace kerf {

/// An object in figures, in the scene's units.
struct ObjectFigures {
  ObjectId object;
  bool is_fixed = false;
  std::uint32_t leaves = 0;    ///< that store it
  std::uint32_t pairs = 0;     ///< of the step
  std::vector<double> centre;  ///< of its box, one number an axis
  std::vector<double> size;    ///< of its box
};

/// Of all objects that are placed, by id.
template <int D>
std::vector<ObjectFigures> find_object_figures(const BspState<D>& state);

}  // namespace kerf
