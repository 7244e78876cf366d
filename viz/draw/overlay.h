#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "viz/draw/draw_context.h"
#include "viz/draw/highlights.h"
#include "viz/draw/painter.h"

namespace kerf {

/// The overlay of the scene: shapes, then letters.
struct Overlay {
  Batch shapes;
  TextBatch text;
  void clear() {
    shapes.clear();
    text.clear();
  }
};

/// Height of letters for a picture of so many rows.
int font_pixels(int picture_height);

/// A picture's bands: the caption above and the legend below keep out of the scene's viewport.
struct Layout {
  int caption_height = 0;
  int legend_height = 0;
  Viewport scene;
};

/// A word and its value, kept on one line.
struct CaptionItem {
  std::string word;
  std::string value;
  bool begins_line = false;
};

/// One swatch of the legend.
enum class Swatch {
  moving,
  fixed,
  straddler,
  population,
  partitioner,
  candidate,
  contact,
  missed,
  extra,
  highlight
};
struct LegendItem {
  Swatch swatch;
  std::string text;
};

/// The caption's items in order. Numbers have room to grow, so that they stand still in a film.
std::vector<CaptionItem> caption_items(const Caption& caption, bool has_tree,
                                       std::optional<std::uint32_t> outside = std::nullopt);
/// The items that the layers shown call for. `largest_population`: "64", where the ramp ends. `has_theirs`:
/// another engine's errors are drawn.
std::vector<LegendItem> legend_items(LayerSet layers, int dimension, bool has_tree,
                                     const std::string& largest_population, bool has_theirs = false);

Layout make_layout(const Font& font, int width, int height, const std::vector<CaptionItem>& caption,
                   bool has_log, const std::vector<LegendItem>& legend);

/// The note and the recent operators, newest first, in one line. Without a note they have sentences, beside
/// one or where no sentence has room their names. Operators without room are counted ("and 3 more"); a note
/// that is too long itself ends with "...".
std::string log_line(const Font& font, int picture_width, const std::string& note,
                     const std::vector<Highlight>& highlights);

/// `log`: one line below the caption's numbers.
void draw_caption(const View& view, const Font& font, const Layout& layout,
                  const std::vector<CaptionItem>& items, const std::string& log, Overlay& overlay);
void draw_legend(const View& view, const Font& font, const Layout& layout,
                 const std::vector<LegendItem>& items, double line_scale, Overlay& overlay);
/// Names the highlighted operators at the edge of the scene, with a line to each; labels never overlap each
/// other.
void draw_highlight_labels(const View& view, const Font& font, const Layout& layout,
                           const std::vector<Highlight>& highlights, Overlay& overlay);

}  // namespace kerf
