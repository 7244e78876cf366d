#include "viz/debugger/window/drop.h"

#include <algorithm>

namespace kerf {
namespace {

constexpr float kDropEdge = 0.25F;  // the share of a cell, or of the view, that is its edge

/// The first or last part of an area, along a row or down a column.
PanelArea end_of_area(const PanelArea& area, bool is_along, bool is_first, float share) {
  PanelArea part = area;
  float& size = is_along ? part.width : part.height;
  size *= share;
  if (!is_first) (is_along ? part.x : part.y) += (is_along ? area.width : area.height) - size;
  return part;
}

std::optional<PanelDrop> drop_on_cell(const PanelCell& cell, const ArrangedCell& at, PanelId panel, float x,
                                      float y) {
  const bool is_along = at.index.place == PanelPlace::below;
  const float share = is_along ? (x - at.area.x) / at.area.width : (y - at.area.y) / at.area.height;
  const bool has_it = std::ranges::find(cell.tabs, panel) != cell.tabs.end();
  if (has_it && cell.tabs.size() == 1) return std::nullopt;
  if (share < kDropEdge)
    return PanelDrop{{at.index, DropSide::before}, end_of_area(at.area, is_along, true, 0.5F)};
  if (share > 1 - kDropEdge)
    return PanelDrop{{at.index, DropSide::after}, end_of_area(at.area, is_along, false, 0.5F)};
  if (has_it) return std::nullopt;
  return PanelDrop{{at.index, DropSide::tab}, at.area};
}

/// At the edges of the view a panel goes to a place that has none.
std::optional<PanelDrop> drop_on_view(const WindowLayout& layout, const PanelArea& middle, float x, float y) {
  const auto drop = [&](PanelPlace place, bool is_along, bool is_first) -> std::optional<PanelDrop> {
    if (!layout.cells(place).empty()) return std::nullopt;
    return PanelDrop{{{place, 0}, DropSide::after}, end_of_area(middle, is_along, is_first, kDropEdge)};
  };
  const float across = (x - middle.x) / middle.width;
  if (across < kDropEdge) return drop(PanelPlace::left, true, true);
  if (across > 1 - kDropEdge) return drop(PanelPlace::right, true, false);
  const bool is_low = (y - middle.y) / middle.height > 1 - kDropEdge;
  return is_low ? drop(PanelPlace::below, false, false) : std::nullopt;
}

}  // namespace

std::optional<PanelDrop> drop_at(const WindowLayout& layout, const Arrangement& arrangement, PanelId panel,
                                 float x, float y) {
  const auto found =
      std::ranges::find_if(arrangement.cells, [&](const ArrangedCell& cell) { return cell.area.has(x, y); });
  if (found != arrangement.cells.end())
    return drop_on_cell(layout.cells(found->index.place)[found->index.cell], *found, panel, x, y);
  PanelArea middle = arrangement.tools;
  middle.height = arrangement.view.bottom() - middle.y;
  return middle.has(x, y) ? drop_on_view(layout, middle, x, y) : std::nullopt;
}

}  // namespace kerf
