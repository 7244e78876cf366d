#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "viz/draw/panes.h"

namespace kerf {

/// Serialises panes for another process of the same program.
template <int D>
std::vector<std::uint8_t> pack_panes(const PanesFrame<D>& frame);
/// Throws std::runtime_error if the bytes end too soon.
template <int D>
PanesFrame<D> unpack_panes(std::span<const std::uint8_t> bytes);

}  // namespace kerf
