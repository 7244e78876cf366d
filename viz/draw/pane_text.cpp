#include "viz/draw/pane_text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

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
  std::snprintf(text, sizeof text, "%7.3f ms", time.value_or(0));
  return time ? text : right_aligned("?", 7) + " ms";
}

template <int D>
std::vector<std::string> figures_of(const StructurePane<D>& pane, bool is_timed) {
  const PaneFigures& figures = pane.figures;
  const StructureMeasures& structure = figures.structure;
  std::vector<std::string> items{"tests " + figure(figures.tests, 7), "pairs " + figure(figures.pairs, 6)};
  if (!pane.parts.cells.empty()) {
    items.push_back("cells " + figure(structure.cells, 5));
    if (structure.has_parents) items.push_back("depth " + figure(structure.depth, 2));
    if (structure.overlap > 0) items.push_back("overlap " + whole_percent(structure.overlap));
    items.push_back("dead " + whole_percent(structure.dead));
  } else if (!pane.parts.lists.empty()) {
    items.push_back("lists " + figure(pane.parts.lists.size(), 1));
  }
  items.push_back(right_aligned(figures.bytes ? std::to_string((*figures.bytes + 512) / 1024) : "?", 6) +
                  " kB");
  if (is_timed) items.push_back(milliseconds(figures.milliseconds));
  return items;
}

std::string shortened(std::string text, std::size_t letters) {
  if (text.size() <= letters || letters < 4) return text;
  return text.substr(0, letters - 3) + "...";
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
    if (legend.has_straddlers) items.push_back({PaneMark::block, palette::kStraddler, "in 2+ cells"});
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
        return add_line_on_picture(batch_, view_, a, b, {item.color, scale_});
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
std::vector<std::string> pane_lines(const StructurePane<D>& pane, bool is_timed, std::size_t letters) {
  constexpr std::size_t kGap = 2;
  std::vector<std::string> lines{
      shortened(pane.name + (pane.parts.kind.empty() ? "" : ": " + pane.parts.kind), letters), ""};
  for (const std::string& item : figures_of(pane, is_timed)) {
    if (!lines.back().empty() && lines.back().size() + kGap + item.size() > letters) lines.emplace_back();
    lines.back() += (lines.back().empty() ? "" : std::string(kGap, ' ')) + item;
  }
  if (!pane.parts.unseen.empty()) lines.push_back(shortened(pane.parts.unseen, letters));
  return lines;
}

template <int D>
std::string panes_title(const PanesFrame<D>& frame) {
  return "scene " + frame.scene + "  step " + figure(frame.step, 5) + "  objects " +
         figure(frame.bodies.size(), 5) + "  moving " + figure(frame.moving, 5);
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

template std::vector<std::string> pane_lines(const StructurePane<2>&, bool, std::size_t);
template std::vector<std::string> pane_lines(const StructurePane<3>&, bool, std::size_t);
template std::string panes_title(const PanesFrame<2>&);
template std::string panes_title(const PanesFrame<3>&);

}  // namespace kerf
