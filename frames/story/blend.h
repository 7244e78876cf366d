#pragma once

#include <vector>

#include "core/scene/scene.h"

namespace kerf {

/// The bodies on their way from one step to the next, `part` of it done, from 0 to 1. A body that only the
/// later step has is not there yet.
template <int D>
std::vector<Body<D>> blend(const std::vector<Body<D>>& from, const std::vector<Body<D>>& to, double part);

}  // namespace kerf
