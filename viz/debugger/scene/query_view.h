#pragma once

#include <span>
#include <vector>

#include "core/query/explain_query.h"
#include "core/scene/scene.h"
#include "viz/debugger/scene/their_nodes_view.h"
#include "viz/draw/draw_context.h"

namespace kerf {

/// How the tree answers a query: what was asked, the bounds of the nodes that were visited and, dashed, of
/// those that were pruned, and the boxes that were found. The texts stand at the first of these.
template <int D>
std::vector<PlacedText> draw_query(const DrawContext<D>& frame, const QueryExplanation<D>& explanation,
                                   std::span<const Body<D>> bodies, const GivenNames& names, Batch& front);

}  // namespace kerf
