#pragma once

#include <string>
#include <vector>

#include "viz/draw/font.h"
#include "viz/draw/overlay.h"
#include "viz/draw/panes.h"

namespace kerf {

/// The lines above a pane: what it is, its numbers in places that do not move in a film, and faint what
/// cannot be seen.
struct PaneLines {
  std::vector<std::string> plain;
  std::vector<std::string> faint;
  [[nodiscard]] std::size_t size() const { return plain.size() + faint.size(); }
};
template <int D>
PaneLines pane_lines(const StructurePane<D>& pane, bool is_timed, std::size_t letters);

/// The line above all panes.
template <int D>
std::string panes_title(const PanesFrame<D>& frame);

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
/// Draws it with its top left corner at (0, top).
void draw_panes_legend(const PanesLegend& legend, const View& view, const Font& font, int top, double scale,
                       Overlay& overlay);

}  // namespace kerf
