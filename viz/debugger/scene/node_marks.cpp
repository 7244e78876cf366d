#include "viz/debugger/scene/node_marks.h"

#include "viz/draw/cells.h"
#include "viz/draw/palette.h"
#include "viz/draw/strokes.h"

namespace kerf {
namespace {

template <int D>
std::optional<Eigen::Vector3d> outline_place(const DrawContext<D>& frame, const TreeSnapshotOf<D>& tree,
                                             NodeId id, const Box<D>& space, Batch& batch) {
  std::optional<Eigen::Vector3d> top;
  for (const Polygon& face : cell_faces(tree, id, space)) {
    add_outline(batch, frame.view, face, {palette::kOperator, 2 * frame.line_scale});
    for (const Eigen::Vector3d& corner : face)
      if (!top || corner.y() > top->y()) top = corner;
  }
  return top;
}

/// Where what was below a removed node is drawn; everywhere if that is gone, too.
template <int D>
Box<D> space_of_children(const DrawContext<D>& frame, const TreeSnapshotOf<D>& before, NodeId id) {
  Box<D> space = Box<D>::empty();
  for (const NodeId child : {before[id].left, before[id].right})
    if (frame.snapshot.is_alive(child)) space = join(space, frame.space_of(child));
  return is_valid(space) ? space : frame.bounds;
}

}  // namespace

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

template <int D>
std::optional<Eigen::Vector3d> mark_removed(const DrawContext<D>& frame, const TreeSnapshotOf<D>& before,
                                            NodeId id, Batch& batch) {
  if (!before.is_alive(id)) return std::nullopt;
  const double scale = frame.line_scale;
  const Box<D> space = space_of_children(frame, before, id);
  if (!before[id].is_leaf())
    add_outline(batch, frame.view, partitioner_in_cell(before, id, space),
                {palette::kOperator, 2 * scale, 7 * scale, 5 * scale});
  return outline_place(frame, before, id, space, batch);
}

template <int D>
std::optional<Eigen::Vector3d> mark_acted(const DrawContext<D>& frame, NodeId id, Batch& batch) {
  return outline_place(frame, frame.snapshot, id, frame.space_of(id), batch);
}

template void mark_selected(const DrawContext<2>&, NodeId, Batch&);
template void mark_selected(const DrawContext<3>&, NodeId, Batch&);
template void mark_hovered(const DrawContext<2>&, NodeId, Batch&);
template void mark_hovered(const DrawContext<3>&, NodeId, Batch&);
template std::optional<Eigen::Vector3d> mark_removed(const DrawContext<2>&, const TreeSnapshotOf<2>&, NodeId,
                                                     Batch&);
template std::optional<Eigen::Vector3d> mark_removed(const DrawContext<3>&, const TreeSnapshotOf<3>&, NodeId,
                                                     Batch&);
template std::optional<Eigen::Vector3d> mark_acted(const DrawContext<2>&, NodeId, Batch&);
template std::optional<Eigen::Vector3d> mark_acted(const DrawContext<3>&, NodeId, Batch&);

}  // namespace kerf
