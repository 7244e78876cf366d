#pragma once

#include <vector>

#include "core/broad_phase/object_table.h"
#include "core/scene/scene.h"

namespace kerf {

/// The objects as a recording knows them: boxes. Who is not there is a point in the middle of somebody else,
/// since bodies are numbered as objects are.
template <int D>
std::vector<Body<D>> bodies_of(const ObjectTable<D>& objects);

}  // namespace kerf
