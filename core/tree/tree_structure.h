#pragma once

#include "core/objects/structure.h"
#include "core/tree/tree.h"

namespace kerf {

/// Describes the tree as a structure: its nodes are cells cut by their parents' partitioners, its entries the
/// members. `has_lists`: leaves keep the paper's ordered lists, from which the tests follow.
template <int D>
void describe_tree(const Tree<D>& tree, bool has_lists, StructureParts<D>& parts);

}  // namespace kerf
