#pragma once

#include <optional>

#include "viz/draw/draw_context.h"

namespace kerf {

/// The cell of a living node and its partitioner, as what is selected; of another one nothing.
template <int D>
void mark_selected(const DrawContext<D>& frame, NodeId id, Batch& batch);

/// The cell of a living node, as what is under the mouse in a panel.
template <int D>
void mark_hovered(const DrawContext<D>& frame, NodeId id, Batch& batch);

/// The cell of a node that has been removed, and where its partitioner was, in the tree before that. The
/// highest corner; none if it did not live there.
template <int D>
std::optional<Eigen::Vector3d> mark_removed(const DrawContext<D>& frame, const TreeSnapshotOf<D>& before,
                                            NodeId id, Batch& batch);

/// The cell of a living node, as where something has just happened; its highest corner.
template <int D>
std::optional<Eigen::Vector3d> mark_acted(const DrawContext<D>& frame, NodeId id, Batch& batch);

}  // namespace kerf
