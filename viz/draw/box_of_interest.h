#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "core/scene/scene.h"

namespace kerf {

/// Which bodies a picture is made for.
enum class Framing {
  most,  ///< what most of them span: one that fell off or lies far away must not shrink the rest to a dot
  everything,  ///< every finite one
};

/// What a picture of these bodies should hold; nothing if there is none to be seen.
///
/// `most`: between the tenth smallest and the tenth largest of a hundred lies the bulk. What is fixed counts
/// unless it reaches beyond a hundred times the bulk, and gives a region around it in which what moves
/// counts. Where there is none, or the crowd is not in it, what moves counts within two sizes of the bulk
/// around it. Of what reaches farther only the part near the bulk counts.
template <int D>
std::optional<Box<D>> box_of_interest(std::span<const Body<D>> bodies, Framing framing);

/// Bodies of which no part lies in the box.
template <int D>
std::uint32_t count_outside(std::span<const Body<D>> bodies, const Box<D>& box);

}  // namespace kerf
