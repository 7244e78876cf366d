#pragma once

#include <span>
#include <vector>

#include "core/scene/scene.h"
#include "viz/debugger/scene/tints.h"
#include "viz/debugger/scene/visibility.h"

namespace kerf {

/// Colours of objects by their leaves, as far as these are tinted. `tint_end`: the value of the brightest.
template <int D>
std::vector<Color> body_colors(std::span<const Body<D>> bodies, const Visibility& visible,
                               const NodeTints& tints, double tint_end, bool tinted);
/// By node; transparent where nothing is seen.
std::vector<Color> leaf_colors(const Visibility& visible, const NodeTints& tints, double tint_end);

}  // namespace kerf
