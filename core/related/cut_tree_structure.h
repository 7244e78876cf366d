#pragma once

#include "core/objects/structure.h"
#include "core/related/cut_tree.h"

namespace kerf {

/// The nodes of a tree of cuts, cut by planes; in each leaf all boxes are compared.
template <int D>
void describe_cut_tree(const CutTree<D>& tree, StructureParts<D>& parts);

}  // namespace kerf
