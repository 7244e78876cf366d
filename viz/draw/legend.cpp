#include "viz/draw/flow.h"
#include "viz/draw/letters.h"
#include "viz/draw/overlay.h"
#include "viz/draw/palette.h"
#include "viz/draw/strokes.h"

namespace kerf {
namespace {

int swatch_width(const Font& font, Swatch swatch) {
  const bool is_block = swatch == Swatch::moving || swatch == Swatch::fixed || swatch == Swatch::straddler ||
                        swatch == Swatch::highlight;
  return (swatch == Swatch::population ? 6 : is_block ? 2 : 3) * font.advance();
}

/// Draws swatches into the box of one line of text.
class SwatchPainter {
 public:
  SwatchPainter(const View& view, double line_scale, Batch& batch)
      : view_(view), scale_(line_scale), batch_(batch) {}

  void draw(Swatch swatch, const Viewport& box) const {
    switch (swatch) {
      case Swatch::moving:
        return block(box, palette::kMoving);
      case Swatch::fixed:
        return block(box, palette::kFixed);
      case Swatch::straddler:
        return block(box, palette::kStraddler);
      case Swatch::population:
        return ramp(box);
      case Swatch::partitioner:
        return bar(box, {palette::kPartitioner, 2 * scale_});
      case Swatch::candidate:
        return bar(box, {palette::kCandidate, 1.3 * scale_, 4 * scale_, 3 * scale_});
      case Swatch::contact:
        bar(box, {palette::kContact, 2 * scale_});
        return add_diamond_on_picture(batch_, view_, {box.left + box.width / 2, box.top + box.height / 2},
                                      4 * scale_, palette::kContact);
      case Swatch::missed:
        return error(box, palette::kMissed);
      case Swatch::extra:
        return error(box, palette::kExtra);
      case Swatch::highlight:
        return frame(box, {palette::kOperator, 3 * scale_});
    }
  }

 private:
  void block(const Viewport& box, Color color) const {
    add_rectangle_on_picture(batch_, view_, box, lit(color, 0.45));
    const double rim = 1.2 * scale_;
    add_rectangle_on_picture(
        batch_, view_, {box.left + rim, box.top + rim, box.width - 2 * rim, box.height - 2 * rim}, color);
  }

  void ramp(const Viewport& box) const {
    constexpr std::uint32_t kSteps = 24;
    const double width = box.width / kSteps;
    for (std::uint32_t i = 0; i < kSteps; ++i) {
      add_rectangle_on_picture(batch_, view_, {box.left + i * width, box.top, width, box.height},
                               palette::population_color(i, kSteps - 1));
    }
  }

  void bar(const Viewport& box, const Stroke& stroke) const {
    const double y = box.top + box.height / 2;
    add_line_on_picture(batch_, view_, {box.left, y}, {box.left + box.width, y}, stroke);
  }

  void error(const Viewport& box, Color color) const {
    const Eigen::Vector2d middle(box.left + box.width / 2, box.top + box.height / 2);
    bar(box, {palette::kInk, 4 * scale_});
    add_diamond_on_picture(batch_, view_, middle, 6 * scale_, palette::kInk);
    bar(box, {color, 2 * scale_});
    add_diamond_on_picture(batch_, view_, middle, 4.5 * scale_, color);
  }

  void frame(const Viewport& box, const Stroke& stroke) const {
    const Eigen::Vector2d a(box.left, box.top);
    const Eigen::Vector2d c(box.left + box.width, box.top + box.height);
    const Eigen::Vector2d b(c.x(), a.y());
    const Eigen::Vector2d d(a.x(), c.y());
    add_line_on_picture(batch_, view_, a, b, stroke);
    add_line_on_picture(batch_, view_, b, c, stroke);
    add_line_on_picture(batch_, view_, c, d, stroke);
    add_line_on_picture(batch_, view_, d, a, stroke);
  }

  const View& view_;
  double scale_;
  Batch& batch_;
};

}  // namespace

std::vector<LegendItem> legend_items(LayerSet layers, int dimension, bool has_tree,
                                     const std::string& largest_population, bool has_theirs) {
  const bool tinted = layers.has(Layer::leaves) && has_tree;
  std::vector<LegendItem> items;
  if (layers.has(Layer::objects)) {
    if (dimension == 2 || !tinted) items.push_back({Swatch::moving, "moving"});
    items.push_back({Swatch::fixed, "fixed"});
    if (tinted) items.push_back({Swatch::straddler, "in 2+ leaves"});
  }
  if (tinted && (dimension == 2 || layers.has(Layer::objects))) {
    const std::string what = dimension == 2 ? "leaf of 0-" : "in a leaf of 0-";
    items.push_back({Swatch::population, what + largest_population});
  }
  if (layers.has(Layer::partitioners) && has_tree) items.push_back({Swatch::partitioner, "partitioner"});
  if (layers.has(Layer::pairs)) {
    const bool apart = layers.has(Layer::contacts);
    items.push_back({Swatch::candidate, apart ? "pair, no contact" : "pair"});
  }
  if (layers.has(Layer::contacts)) items.push_back({Swatch::contact, "contact"});
  if (layers.has(Layer::pairs) && has_theirs) {
    items.push_back({Swatch::missed, "missed"});
    items.push_back({Swatch::extra, "extra"});
  }
  if (layers.has(Layer::operators) && has_tree) items.push_back({Swatch::highlight, "operator"});
  return items;
}

std::vector<flow::Piece> flow::pieces_of(const Font& font, std::span<const LegendItem> items) {
  std::vector<Piece> pieces;
  for (const LegendItem& item : items)
    pieces.push_back({swatch_width(font, item.swatch) + font.advance() + font.width(item.text)});
  return pieces;
}

void draw_legend(const View& view, const Font& font, const Layout& layout,
                 const std::vector<LegendItem>& items, double line_scale, Overlay& overlay) {
  if (layout.legend_height == 0) return;
  const double top = view.picture_height - layout.legend_height;
  add_rectangle_on_picture(overlay.shapes, view, {0, top, view.picture_width, double(layout.legend_height)},
                           palette::kPanel);
  const SwatchPainter painter(view, line_scale, overlay.shapes);
  const int pad = flow::padding(font);
  const int right = static_cast<int>(view.picture_width) - pad;
  const int room = (layout.legend_height - pad) / font.line_height();
  const auto [shown, spots] =
      flow::fit_across(font, static_cast<int>(view.picture_width), room, flow::pieces_of(font, items));
  const auto y_of = [&](const flow::Spot& spot) {
    return static_cast<int>(top) + pad + spot.line * font.line_height();
  };
  for (std::size_t i = 0; i < shown; ++i) {
    const int y = y_of(spots[i]);
    const int width = swatch_width(font, items[i].swatch);
    const int x = spots[i].x + width + font.advance();
    painter.draw(items[i].swatch, {double(spots[i].x), y + 0.2 * font.line_height(), double(width),
                                   0.55 * font.line_height()});
    overlay.text.add(font, x, y, shortened(items[i].text, font.letters(right - x)), palette::kInk);
  }
  if (shown < items.size())
    overlay.text.add(font, spots.back().x, y_of(spots.back()), flow::kMore, palette::kInk);
}

}  // namespace kerf
