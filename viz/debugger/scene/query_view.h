#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/query/explain_query.h"
#include "core/scene/scene.h"
#include "viz/debugger/scene/their_nodes_view.h"
#include "viz/draw/draw_context.h"

namespace kerf {

/// What to ask about a pixel, see `parse_query`: in 3D the ray from the eye through it, in 2D the point.
template <int D>
std::string query_through(const View& view, double x, double y);

/// How the tree answers a query: what was asked, the bounds of the nodes that were visited and, dashed, of
/// those that were pruned, and the boxes that were found. The texts stand at the first of these.
template <int D>
std::vector<PlacedText> draw_query(const DrawContext<D>& frame, const QueryExplanation<D>& explanation,
                                   std::span<const Body<D>> bodies, const GivenNames& names, Batch& front);

}  // namespace kerf
