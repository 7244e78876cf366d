#pragma once

#include <string>
#include <vector>

#include "viz/draw/font.h"
#include "viz/draw/overlay.h"
#include "viz/draw/panes.h"

namespace kerf {

/// The room for the words of a pane, one line at least.
struct PaneRoom {
  std::size_t letters = 1;
  std::size_t lines = 1;
};

/// The lines above a pane: what it is, its numbers in places that do not move in a film, and faint what
/// cannot be seen. "..." stands for what has no room.
struct PaneLines {
  std::vector<std::string> plain;
  std::vector<std::string> faint;
  [[nodiscard]] std::size_t size() const { return plain.size() + faint.size(); }
};
template <int D>
PaneLines pane_lines(const StructurePane<D>& pane, bool is_timed, const PaneRoom& room);

/// The lines above all panes.
template <int D>
std::vector<std::string> panes_title(const PanesFrame<D>& frame, std::size_t letters);

/// What the colours and lines of panes mean.
struct PanesLegend {
  int dimension = 2;
  bool has_cells = false;
  bool has_lists = false;
  bool has_straddlers = false;  ///< objects can be in several cells
  bool has_rejected = false;
  LayerSet layers = LayerSet::all();
};
/// The lines that it takes at that width.
int legend_lines(const PanesLegend& legend, const Font& font, int width);
/// Draws it with its top left corner at (0, top), as far as it has room below.
void draw_panes_legend(const PanesLegend& legend, const View& view, const Font& font, int top, double scale,
                       Overlay& overlay);

}  // namespace kerf
