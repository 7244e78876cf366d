#pragma once

#include "viz/draw/draw_context.h"

namespace kerf {

/// The cell of a living node and its partitioner, as what is selected; of another one nothing.
template <int D>
void mark_selected(const DrawContext<D>& frame, NodeId id, Batch& batch);

/// The cell of a living node, as what is under the mouse in a panel.
template <int D>
void mark_hovered(const DrawContext<D>& frame, NodeId id, Batch& batch);

}  // namespace kerf
