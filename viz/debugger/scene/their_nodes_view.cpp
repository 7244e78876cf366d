#include "viz/debugger/scene/their_nodes_view.h"

#include <algorithm>
#include <optional>

#include "viz/debugger/scene/outline_box.h"
#include "viz/draw/palette.h"
#include "viz/draw/structure_draw.h"

namespace kerf {
namespace {

constexpr double kFaultLine = 2.5;  // pixels, and its edges
constexpr double kFaultEdge = 5;
constexpr std::size_t kMostTexts = 6;  // more would hide the scene

/// The box of what a fault is about: its node, or else its object.
template <int D>
std::optional<Box<D>> box_of(const DrawContext<D>& frame, const StructureParts<D>& parts,
                             const StructureFault& fault) {
  const auto cell = std::ranges::find(parts.cells, fault.cell, &StructureCell<D>::name);
  if (fault.cell != kNoPart && cell != parts.cells.end()) return with_ends(cell->box, frame.bounds);
  const std::size_t object = fault.object.index();
  if (fault.object.is_none() || object >= frame.input.bodies.size()) return std::nullopt;
  const Body<D>& body = frame.input.bodies[object];
  return is_drawable(body) ? std::optional(body.box) : std::nullopt;
}

}  // namespace

template <int D>
void draw_their_nodes(const DrawContext<D>& frame, const StructureParts<D>& parts, LayerSet layers,
                      Batch& areas, Batch& outlines) {
  if constexpr (D == 2)
    if (layers.has(Layer::leaves)) draw_cell_areas(frame, parts, areas);
  if (layers.has(Layer::partitioners)) draw_cell_outlines(frame, parts, outlines);
}

template <int D>
std::vector<PlacedText> draw_their_faults(const DrawContext<D>& frame, const StructureParts<D>& parts,
                                          std::span<const StructureFault> faults, Batch& front) {
  std::vector<PlacedText> texts;
  for (const StructureFault& fault : faults) {
    const auto box = box_of(frame, parts, fault);
    if (!box) continue;
    outline_box(frame, *box, {palette::kInk, kFaultEdge * frame.line_scale}, front);
    outline_box(frame, *box, {palette::kMissed, kFaultLine * frame.line_scale}, front);
    if (texts.size() < kMostTexts)
      texts.emplace_back(to_point(box->max), fault.text.substr(0, fault.text.find(':')));
  }
  return texts;
}

template void draw_their_nodes(const DrawContext<2>&, const StructureParts<2>&, LayerSet, Batch&, Batch&);
template void draw_their_nodes(const DrawContext<3>&, const StructureParts<3>&, LayerSet, Batch&, Batch&);
template std::vector<PlacedText> draw_their_faults(const DrawContext<2>&, const StructureParts<2>&,
                                                   std::span<const StructureFault>, Batch&);
template std::vector<PlacedText> draw_their_faults(const DrawContext<3>&, const StructureParts<3>&,
                                                   std::span<const StructureFault>, Batch&);

}  // namespace kerf
