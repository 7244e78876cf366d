#include "viz/draw/pane_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <span>
#include <sstream>

#include "viz/draw/flow.h"
#include "viz/draw/letters.h"
#include "viz/draw/palette.h"
#include "viz/draw/strokes.h"
#include "viz/draw/structure_draw.h"

namespace kerf {
namespace {

constexpr std::size_t kBetween = 2;  // letters between items of a line

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

/// Lines of whole items; one that is longer than a line loses its end.
std::vector<std::string> lines_of(std::span<const std::string> items, std::size_t between,
                                  std::size_t letters) {
  std::vector<std::string> lines{""};
  for (const std::string& item : items) {
    const std::size_t taken = count_letters(lines.back()) + between;
    if (!lines.back().empty() && taken + count_letters(item) > letters) lines.emplace_back();
    lines.back() += (lines.back().empty() ? "" : std::string(between, ' ')) + shortened(item, letters);
  }
  return lines;
}

/// The same in so many lines: "..." stands for the items that have no room.
std::vector<std::string> lines_within(std::vector<std::string> items, std::size_t between,
                                      const PaneRoom& room) {
  std::vector<std::string> lines = lines_of(items, between, room.letters);
  while (lines.size() > room.lines && items.size() > 2) {
    if (items.back() == flow::kMore) items.pop_back();
    items.back() = flow::kMore;
    lines = lines_of(items, between, room.letters);
  }
  if (lines.size() <= room.lines) return lines;
  lines.resize(room.lines);
  lines.back() = shortened(lines.back() + " " + flow::kMore, room.letters);
  return lines;
}

std::vector<std::string> words_of(const std::string& text) {
  using Words = std::istream_iterator<std::string>;
  std::istringstream stream(text);
  return std::vector<std::string>(Words(stream), Words());
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
  if (legend.has_cells && shown.has(Layer::leaves) && (legend.dimension == 2 || shown.has(Layer::objects))) {
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

std::vector<flow::Piece> pieces_of(const std::vector<LegendMark>& items, const Font& font) {
  std::vector<flow::Piece> pieces;
  for (const LegendMark& item : items)
    pieces.push_back({width_of(font, item.mark) + font.advance() + font.width(item.text)});
  return pieces;
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
PaneLines pane_lines(const StructurePane<D>& pane, bool is_timed, const PaneRoom& room) {
  PaneLines lines;
  const std::string name = pane.name + (pane.parts.kind.empty() ? "" : ": " + pane.parts.kind);
  lines.plain = lines_within(words_of(name), 1, {room.letters, std::max<std::size_t>(2, room.lines) - 1});
  const auto left = [&] { return room.lines - std::min(room.lines, lines.size()); };
  if (left() > 0) {
    const auto figures = lines_within(figures_of(pane, is_timed), kBetween, {room.letters, left()});
    lines.plain.insert(lines.plain.end(), figures.begin(), figures.end());
  }
  if (!pane.parts.unseen.empty() && left() > 0)
    lines.faint = lines_within(words_of(pane.parts.unseen), 1, {room.letters, left()});
  return lines;
}

template <int D>
std::vector<std::string> panes_title(const PanesFrame<D>& frame, std::size_t letters) {
  const std::string step = frame.step_name.empty() ? figure(frame.step, 5) : frame.step_name;
  const std::array<std::string, 4> items{"scene " + frame.scene, "step " + step,
                                         "objects " + figure(frame.objects, 5),
                                         "moving " + figure(frame.moving, 5)};
  return lines_of(items, kBetween, letters);
}

int legend_lines(const PanesLegend& legend, const Font& font, int width) {
  return flow::lines(flow::arrange_across(font, width, pieces_of(items_of(legend), font)));
}

void draw_panes_legend(const PanesLegend& legend, const View& view, const Font& font, int top, double scale,
                       Overlay& overlay) {
  const std::vector<LegendMark> items = items_of(legend);
  const int pad = flow::padding(font);
  const int right = static_cast<int>(view.picture_width) - pad;
  const int room = (static_cast<int>(view.picture_height) - top - pad) / font.line_height();
  const auto [shown, spots] = flow::fit_across(font, right + pad, room, pieces_of(items, font));
  const LegendMarkPainter painter(view, scale, overlay.shapes);
  const auto y_of = [&](const flow::Spot& spot) { return top + pad + spot.line * font.line_height(); };
  for (std::size_t i = 0; i < shown; ++i) {
    const int y = y_of(spots[i]);
    const int width = width_of(font, items[i].mark);
    const int x = spots[i].x + width + font.advance();
    painter.draw(items[i], {double(spots[i].x), y + 0.2 * font.line_height(), double(width),
                            0.55 * font.line_height()});
    overlay.text.add(font, x, y, shortened(items[i].text, font.letters(right - x)), palette::kInk);
  }
  if (shown < items.size())
    overlay.text.add(font, spots.back().x, y_of(spots.back()), flow::kMore, palette::kInk);
}

template PaneLines pane_lines(const StructurePane<2>&, bool, const PaneRoom&);
template PaneLines pane_lines(const StructurePane<3>&, bool, const PaneRoom&);
template std::vector<std::string> panes_title(const PanesFrame<2>&, std::size_t);
template std::vector<std::string> panes_title(const PanesFrame<3>&, std::size_t);

}  // namespace kerf
