#include "viz/debugger/scene/node_marks.h"

#include "viz/draw/cells.h"
#include "viz/draw/palette.h"
#include "viz/draw/strokes.h"

namespace kerf {

template <int D>
void mark_selected(const DrawContext<D>& frame, NodeId id, Batch& batch) {
  if (!frame.snapshot.is_alive(id)) return;
  outline_cell(frame, id, {palette::kSelected, 2.5 * frame.line_scale}, batch);
  if (frame.snapshot[id].is_leaf()) return;
  const Polygon plane = partitioner_in_cell(frame.snapshot, id, frame.space_of(id));
  add_polygon(batch, frame.view, plane, with_alpha(palette::kSelected, 0.25));
  add_outline(batch, frame.view, plane, {palette::kSelected, 4 * frame.line_scale});
}

template <int D>
void mark_hovered(const DrawContext<D>& frame, NodeId id, Batch& batch) {
  if (frame.snapshot.is_alive(id)) outline_cell(frame, id, {palette::kInk, 1.5 * frame.line_scale}, batch);
}

template void mark_selected(const DrawContext<2>&, NodeId, Batch&);
template void mark_selected(const DrawContext<3>&, NodeId, Batch&);
template void mark_hovered(const DrawContext<2>&, NodeId, Batch&);
template void mark_hovered(const DrawContext<3>&, NodeId, Batch&);

}  // namespace kerf
