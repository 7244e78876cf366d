#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "core/scene/scene.h"

namespace kerf {

/// The bodies that a picture frames.
enum class Framing {
  most,        ///< what most of them span: one that lies far away must not shrink the rest to a dot
  everything,  ///< every finite one
};

/// The box that a picture of these bodies should frame; none if no body is visible.
///
/// `most`: the bulk lies between the tenth smallest and the tenth largest of a hundred. Fixed bodies
/// count unless they reach beyond a hundred times the bulk; moving ones count within a region around the
/// fixed ones. Without fixed bodies, or if the crowd lies outside of that region, moving ones count
/// within two sizes of the bulk around it. Of a body that reaches farther only the part near the bulk
/// counts.
template <int D>
std::optional<Box<D>> box_of_interest(std::span<const Body<D>> bodies, Framing framing);

/// Bodies of which no part lies in the box.
template <int D>
std::uint32_t count_outside(std::span<const Body<D>> bodies, const Box<D>& box);

}  // namespace kerf
