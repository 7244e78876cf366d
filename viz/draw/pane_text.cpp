#include "viz/draw/pane_text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "viz/draw/flow.h"
#include "viz/draw/palette.h"
#include "viz/draw/strokes.h"
#include "viz/draw/structure_draw.h"

namespace kerf {
namespace {

std::string right_aligned(const std::string& text, std::size_t width) {
  return text.size() < width ? std::string(width - text.size(), ' ') + text : text;
}

std::string figure(std::optional<std::uint64_t> value, std::size_t width) {
  return right_aligned(value ? std::to_string(*value) : "?", width);
}

std::string whole_percent(double share) {
  return right_aligned(std::to_string(std::lround(100 * share)), 3) + " %";
}

std::string milliseconds(std::optional<double> time) {
  char text[32];
  std::snprintf(text, sizeof text, "%6.3f ms", time.value_or(0));
  return time ? text : right_aligned("?", 6) + " ms";
}

/// The same words in each pane, so that a number is found where it is in the others; "-": there is none.
template <int D>
std::vector<std::string> figures_of(const StructurePane<D>& pane, bool is_timed) {
  const PaneFigures& figures = pane.figures;
  const StructureMeasures& structure = figures.structure;
  const bool has_cells = !pane.parts.cells.empty();
  const auto of_cells = [&](const std::string& text) {
    return has_cells ? text : right_aligned("-", text.size());
  };
  std::vector<std::string> items{
      "tests " + figure(figures.tests, 7),
      "pairs " + figure(figures.pairs, 6),
      "cells " + of_cells(figure(structure.cells, 5)),
      "depth " + of_cells(figure(structure.depth, 2)),
      "overlap " + of_cells(whole_percent(structure.overlap)),
      "dead " + of_cells(whole_percent(structure.dead)),
      "mem " + (figures.bytes ? figure((*figures.bytes + 512) / 1024, 5) : right_aligned("?", 5)) + " kB"};
  if (is_timed) items.push_back(milliseconds(figures.milliseconds));
  return items;
}

/// Lines of whole words.
std::vector<std::string> wrapped(const std::string& text, std::size_t letters) {
  std::vector<std::string> lines{""};
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (!lines.back().empty() && lines.back().size() + 1 + word.size() > letters) lines.emplace_back();
    lines.back() += (lines.back().empty() ? "" : " ") + word;
  }
  return lines;
}

enum class PaneMark { block, depths, fills, line, dashed, contact, strip };

struct LegendMark {
  PaneMark mark;
  Color color;
  std::string text;
};

std::vector<LegendMark> items_of(const PanesLegend& legend) {
  const LayerSet& shown = legend.layers;
  std::vector<LegendMark> items;
  if (shown.has(Layer::objects)) {
    items.push_back({PaneMark::block, palette::kMoving, "moving"});
    items.push_back({PaneMark::block, palette::kFixed, "fixed"});
    if (legend.has_straddlers && shown.has(Layer::leaves))
      items.push_back({PaneMark::block, palette::kStraddler, "in 2+ cells"});
  }
  if (legend.has_cells && shown.has(Layer::leaves)) {
    items.push_back({PaneMark::fills, {}, "cell of 1 to " + std::to_string(kFullCell) + "+ objects"});
    if (legend.dimension == 2) items.push_back({PaneMark::block, kSiblingOverlap, "siblings overlap"});
  }
  if (legend.has_cells && shown.has(Layer::partitioners))
    items.push_back({PaneMark::depths, {}, "depth 0 to " + std::to_string(kDeepCell) + "+"});
  const bool has_contacts = shown.has(Layer::contacts);
  if (shown.has(Layer::pairs)) {
    items.push_back({PaneMark::dashed, palette::kCandidate, has_contacts ? "pair, no contact" : "pair"});
    if (legend.has_rejected) items.push_back({PaneMark::line, kRejectedTest, "test, no pair"});
  }
  if (has_contacts) items.push_back({PaneMark::contact, palette::kContact, "contact"});
  if (legend.has_lists) items.push_back({PaneMark::strip, kAxisStrip, "open along an axis"});
  return items;
}

int width_of(const Font& font, PaneMark mark) {
  return font.advance() * (mark == PaneMark::depths || mark == PaneMark::fills ? 6
                           : mark == PaneMark::block                           ? 2
                                                                               : 3);
}

std::vector<flow::Spot> arrange(const std::vector<LegendMark>& items, const Font& font, int width) {
  std::vector<flow::Piece> pieces;
  for (const LegendMark& item : items)
    pieces.push_back({width_of(font, item.mark) + font.advance() + font.width(item.text)});
  return flow::arrange(pieces, 2 * font.advance(), flow::padding(font), width - flow::padding(font));
}

class LegendMarkPainter {
 public:
  LegendMarkPainter(const View& view, double scale, Batch& batch)
      : view_(view), scale_(scale), batch_(batch) {}

  void draw(const LegendMark& item, const Viewport& box) const {
    const double middle = box.top + box.height / 2;
    const Eigen::Vector2d a(box.left, middle);
    const Eigen::Vector2d b(box.left + box.width, middle);
    switch (item.mark) {
      case PaneMark::block:
        return block(box, item.color);
      case PaneMark::depths:
        return ramp(
            box, [](std::uint32_t k) { return depth_color(k); }, kDeepCell + 1);
      case PaneMark::fills:
        return ramp(
            box, [](std::uint32_t k) { return fill_color(1U << k); }, 7);
      case PaneMark::line:
        return add_line_on_picture(batch_, view_, a, b, {item.color, std::max(1.0, scale_)});
      case PaneMark::dashed:
        return add_line_on_picture(batch_, view_, a, b, {item.color, 1.3 * scale_, 4 * scale_, 3 * scale_});
      case PaneMark::contact:
        add_line_on_picture(batch_, view_, a, b, {item.color, 2 * scale_});
        return add_diamond_on_picture(batch_, view_, 0.5 * (a + b), 4 * scale_, item.color);
      case PaneMark::strip:
        add_rectangle_on_picture(batch_, view_, {box.left, middle, box.width, box.height / 2},
                                 with_alpha(item.color, 0.45));
        return add_line_on_picture(batch_, view_, {a.x(), box.top + box.height},
                                   {b.x(), box.top + box.height}, {item.color, 1});
    }
  }

 private:
  void block(const Viewport& box, Color color) const {
    const double rim = 1.2 * scale_;
    add_rectangle_on_picture(batch_, view_, box, lit(color, 0.45));
    add_rectangle_on_picture(
        batch_, view_, {box.left + rim, box.top + rim, box.width - 2 * rim, box.height - 2 * rim}, color);
  }
  template <class ColorOf>
  void ramp(const Viewport& box, ColorOf color_of, std::uint32_t steps) const {
    const double width = box.width / steps;
    for (std::uint32_t k = 0; k < steps; ++k)
      add_rectangle_on_picture(batch_, view_, {box.left + k * width, box.top, width, box.height},
                               color_of(k));
  }

  const View& view_;
  double scale_;
  Batch& batch_;
};

}  // namespace

template <int D>
PaneLines pane_lines(const StructurePane<D>& pane, bool is_timed, std::size_t letters) {
  constexpr std::size_t kBetween = 2;
  PaneLines lines;
  lines.plain = wrapped(pane.name + (pane.parts.kind.empty() ? "" : ": " + pane.parts.kind), letters);
  lines.plain.emplace_back();
  for (const std::string& item : figures_of(pane, is_timed)) {
    std::string* line = &lines.plain.back();
    if (!line->empty() && line->size() + kBetween + item.size() > letters) line = &lines.plain.emplace_back();
    *line += (line->empty() ? "" : std::string(kBetween, ' ')) + item;
  }
  if (!pane.parts.unseen.empty()) lines.faint = wrapped(pane.parts.unseen, letters);
  return lines;
}

template <int D>
std::string panes_title(const PanesFrame<D>& frame) {
  const std::string step = frame.step_name.empty() ? figure(frame.step, 5) : frame.step_name;
  return "scene " + frame.scene + "  step " + step + "  objects " + figure(frame.objects, 5) + "  moving " +
         figure(frame.moving, 5);
}

int legend_lines(const PanesLegend& legend, const Font& font, int width) {
  return flow::lines(arrange(items_of(legend), font, width));
}

void draw_panes_legend(const PanesLegend& legend, const View& view, const Font& font, int top, double scale,
                       Overlay& overlay) {
  const std::vector<LegendMark> items = items_of(legend);
  const auto spots = arrange(items, font, static_cast<int>(view.picture_width));
  const LegendMarkPainter painter(view, scale, overlay.shapes);
  for (std::size_t i = 0; i < items.size(); ++i) {
    const int y = top + flow::padding(font) + spots[i].line * font.line_height();
    const int width = width_of(font, items[i].mark);
    painter.draw(items[i], {double(spots[i].x), y + 0.2 * font.line_height(), double(width),
                            0.55 * font.line_height()});
    overlay.text.add(font, spots[i].x + width + font.advance(), y, items[i].text, palette::kInk);
  }
}

template PaneLines pane_lines(const StructurePane<2>&, bool, std::size_t);
template PaneLines pane_lines(const StructurePane<3>&, bool, std::size_t);
template std::string panes_title(const PanesFrame<2>&);
template std::string panes_title(const PanesFrame<3>&);

}  // namespace kerf
