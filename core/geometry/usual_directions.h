#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/vector.h"

namespace kerf {

/// The size and the seed of the direction set that a tree has unless it is asked for another one.
template <int D>
inline constexpr std::uint32_t kUsualDirections = D == 2 ? 64 : 256;
inline constexpr std::uint64_t kUsualSeed = 1;

/// What `spread_directions` gives for these: the first tree of a process need not wait for the repulsion.
template <int D>
std::span<const Vector<D>> usual_directions();
template <>
std::span<const Vector<2>> usual_directions<2>();
template <>
std::span<const Vector<3>> usual_directions<3>();

/// Directions spread by repulsion, see DirectionSet. `size` is from D to 4096. Time grows with its square:
/// 256 take some 20 milliseconds.
template <int D>
std::vector<Vector<D>> spread_directions(std::uint32_t size, std::uint64_t seed);

}  // namespace kerf
