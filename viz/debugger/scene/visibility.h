#pragma once

#include <cstdint>
#include <vector>

#include "core/tree/tree.h"
#include "viz/debugger/model/view_settings.h"

namespace kerf {

/// The visible part of a tree: by node, and by object whether a visible leaf holds it.
struct Visibility {
  std::vector<std::uint8_t> nodes;
  std::vector<std::uint8_t> objects;
  std::vector<NodeId> leaf_of;           ///< by object: the fullest leaf that holds it; none: not in the tree
  std::vector<std::uint8_t> in_several;  ///< by object: more than one leaf holds it
  bool lacks_isolated = false;           ///< the node that is to be alone is not alive: all is visible
};

template <int D>
Visibility find_visible(const Tree<D>& tree, std::size_t objects, const ViewSettings& settings);

/// Whether an object is among the `share` that is drawn: spread evenly, and the same in every picture.
bool is_sampled(std::size_t object, double share);

}  // namespace kerf
