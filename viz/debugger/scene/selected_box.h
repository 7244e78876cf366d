#pragma once

#include <optional>

#include "core/objects/object_table.h"
#include "core/tree/tree_snapshot.h"
#include "viz/debugger/model/selection.h"

namespace kerf {

/// A scene at a moment, as far as something selected has a place in it.
template <int D>
struct Surroundings {
  const ObjectTable<D>& objects;
  const TreeSnapshotOf<D>& tree;
  const Box<D>& bounds;  ///< cells end there
};

/// What an object, both of a pair or the cell of a node take up; none if they are not there.
template <int D>
std::optional<Box<D>> box_of(const Selection& selection, const Surroundings<D>& scene);

}  // namespace kerf
