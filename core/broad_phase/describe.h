#pragma once

#include "core/objects/broad_phase.h"
#include "core/objects/structure.h"

namespace kerf {

/// What the structure of any broad phase looks like after its last step. A tree of ours needs no interface
/// for that: it is a value to be read. Of a broad phase that describes nothing, `unseen` says so.
template <int D>
StructureParts<D> describe(const BroadPhase<D>& broad_phase);

}  // namespace kerf
