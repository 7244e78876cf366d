#pragma once

#include <string>
#include <vector>

#include "viz/debugger/gui/panel_area.h"
#include "viz/debugger/window/window_layout.h"

namespace kerf {

/// The size of a window in units of the panels.
struct WindowSize {
  float width = 0;
  float height = 0;
  std::size_t lanes = 0;    ///< of the timeline, beyond those of each run
  bool has_choice = false;  ///< the view's tools let choose whose structure is seen
};

/// A line that can be dragged: between a place and the view, or between two cells.
struct Divider {
  std::string name;         ///< "divider left", "divider left 1" below the first cell
  CellIndex cell;           ///< before it
  bool is_inner = false;    ///< between two cells
  bool is_upright = false;  ///< it is dragged to the left and right
  PanelArea area;           ///< in which the mouse takes it
};

struct ArrangedCell {
  CellIndex index;
  PanelArea area;
};

/// Where everything is in a window of a size.
struct Arrangement {
  WindowSize size;
  PanelArea transport;
  PanelArea tools;  ///< above the view
  PanelArea view;
  std::vector<ArrangedCell> cells;
  std::vector<Divider> dividers;

  [[nodiscard]] const PanelArea* find(const CellIndex& cell) const;
};
Arrangement arrange(const WindowLayout& layout, const WindowSize& size);

/// The area of the cell that has a panel; empty if it is closed.
PanelArea area_of(PanelId panel, const WindowLayout& layout, const Arrangement& arrangement);

/// The least window in which every panel of the layout has its least size.
WindowSize least_window(const WindowLayout& layout, std::size_t lanes);

/// Brings a divider to a point of the window, as far as the panels on both sides keep their least sizes.
void drag_divider(WindowLayout& layout, const Arrangement& arrangement, const Divider& divider, float x,
                  float y);
/// The default place of a divider.
void reset_divider(WindowLayout& layout, const Divider& divider);

}  // namespace kerf
