#pragma once

#include <cstdint>

#include "core/tree/tree.h"

namespace kerf {

/// A checksum of the whole tree: structure, numbers of nodes, partitioners, entries in their order, and
/// boxes.
template <int D>
std::uint64_t hash(const Tree<D>& tree);

}  // namespace kerf
