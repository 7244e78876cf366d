#pragma once

#include <cstdint>
#include <vector>

#include "core/bsp/bsp_state.h"
#include "core/replay/replayer.h"

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

/// The age of a pair is found over so many steps: an older one has this age.
inline constexpr std::uint32_t kOldestPair = 100;

/// A pair in figures.
struct PairFigures {
  NodeId leaf;            ///< in which the two are compared; none: an object has moved since the last sweep
  double overlap = 0;     ///< of the boxes, on the axis where it is least; not a number: they are apart now
  std::uint32_t age = 0;  ///< steps since the two became a pair
};

/// Of the pairs of a state at its step, in their order. `step` is the step that has found them.
template <int D>
std::vector<PairFigures> find_pair_figures(const BspState<D>& state, Replayer<D>& replayer,
                                           std::uint32_t step);

}  // namespace kerf
