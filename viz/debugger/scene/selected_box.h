#pragma once

#include <optional>

#include "core/objects/object_table.h"
#include "core/tree/tree_snapshot.h"
#include "viz/debugger/model/selection.h"

namespace kerf {

/// A scene at a moment, as far as a selection can have a place in it.
template <int D>
struct Surroundings {
  const ObjectTable<D>& objects;
  const TreeSnapshotOf<D>& tree;
  const Box<D>& bounds;  ///< cells end there
};

/// The bounds of an object, of both objects of a pair or of the cell of a node; none if they do not exist.
template <int D>
std::optional<Box<D>> box_of(const Selection& selection, const Surroundings<D>& scene);

}  // namespace kerf
