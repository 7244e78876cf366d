#include <algorithm>
#include <cmath>

#include "viz/draw/draw_context.h"
#include "viz/draw/palette.h"
#include "viz/draw/strokes.h"

namespace kerf {
namespace {

/// The nearer to the root, the wider.
double line_width(std::uint32_t depth) { return std::max(1.1, 3.0 - 0.4 * depth); }

/// Deeper partitioners are outlines only: hundreds of panes would be a fog, and cost more than everything
/// else.
constexpr std::uint32_t kDeepestPane = 6;

/// Many panes in a row must let the objects behind them through.
double pane_alpha(std::uint32_t leaves) { return std::clamp(0.24 / std::sqrt(1.0 + leaves), 0.02, 0.1); }

}  // namespace

template <int D>
void draw_partitioner(const DrawContext<D>& context, NodeId id, Batch& batch) {
  const std::uint32_t depth = context.snapshot[id].depth;
  const Polygon polygon = partitioner_in_cell(context.snapshot, id, context.space_of(id));
  const double width = line_width(depth) * context.line_scale;
  if constexpr (D == 2) {
    if (!polygon.empty())
      add_line(batch, context.view, polygon[0], polygon[1], {palette::kPartitioner, width});
  } else {
    const double alpha = pane_alpha(context.snapshot.leaves());
    if (depth <= kDeepestPane)
      add_polygon(batch, context.view, polygon, with_alpha(palette::kPartitioner, alpha));
    add_outline(batch, context.view, polygon, {with_alpha(palette::kPartitioner, 0.55), 0.7 * width});
  }
}

template <int D>
void outline_cell(const DrawContext<D>& context, NodeId id, const Stroke& stroke, Batch& batch) {
  for (const Polygon& face : cell_faces(context.snapshot, id, context.space_of(id)))
    add_outline(batch, context.view, face, stroke);
}

template <int D>
void draw_partitioners(const DrawContext<D>& context, Batch& batch) {
  for (const NodeId id : back_to_front(context.snapshot, context.view.eye)) {
    if (context.snapshot[id].is_leaf()) continue;
    context.begin(batch, DrawnKind::plane, id.value);
    draw_partitioner(context, id, batch);
  }
}

template void draw_partitioner<2>(const DrawContext<2>&, NodeId, Batch&);
template void draw_partitioner<3>(const DrawContext<3>&, NodeId, Batch&);
template void outline_cell(const DrawContext<2>&, NodeId, const Stroke&, Batch&);
template void outline_cell(const DrawContext<3>&, NodeId, const Stroke&, Batch&);
template void draw_partitioners<2>(const DrawContext<2>&, Batch&);
template void draw_partitioners<3>(const DrawContext<3>&, Batch&);

}  // namespace kerf
