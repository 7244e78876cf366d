#include <algorithm>
#include <cmath>
#include <optional>

#include "viz/draw/overlay.h"
#include "viz/draw/palette.h"
#include "viz/draw/strokes.h"

namespace kerf {
namespace {

bool overlap(const Viewport& a, const Viewport& b) {
  return a.left < b.left + b.width && b.left < a.left + a.width && a.top < b.top + b.height &&
         b.top < a.top + a.height;
}

/// A place for a label at the edge of the scene nearer to `point`, at the same height, and clear of the
/// others: there it hides nothing.
std::optional<Viewport> find_place(const Eigen::Vector2d& point, double width, double height,
                                   const Viewport& scene, const std::vector<Viewport>& taken) {
  const double margin = 4;
  const bool left = point.x() < scene.left + scene.width / 2.0;
  const double x = left ? scene.left + margin : scene.left + scene.width - width - margin;
  for (int ring = 0; ring < 12; ++ring) {
    for (const int sign : {-1, 1}) {
      const double y = point.y() - height / 2 + sign * ring * (height + 2);
      const double top = std::clamp(y, scene.top, std::max(scene.top, scene.top + scene.height - height));
      const Viewport box{std::round(x), std::round(top), width, height};
      if (std::ranges::none_of(taken, [&](const Viewport& other) { return overlap(box, other); })) return box;
    }
  }
  return std::nullopt;
}

/// From the label to its point.
void add_leader(const View& view, const Viewport& label, const Eigen::Vector2d& point, Color color,
                Batch& batch) {
  const bool is_left = label.left + label.width < point.x();
  const Eigen::Vector2d end{is_left ? label.left + label.width : label.left, label.top + label.height / 2};
  add_line_on_picture(batch, view, end, point, {color, 1.5});
  add_diamond_on_picture(batch, view, point, 4, color);
}

}  // namespace

void draw_highlight_labels(const View& view, const Font& font, const Layout& layout,
                           const std::vector<Highlight>& highlights, Overlay& overlay) {
  const int pad = std::max(4, 3 * font.advance() / 4);
  std::vector<Viewport> taken;
  // The oldest chooses first, so that no label of a film makes way for a newer one.
  for (auto h = highlights.rbegin(); h != highlights.rend(); ++h) {
    const Highlight& highlight = *h;
    if (!highlight.anchor) continue;
    const auto point = view.project(*highlight.anchor);
    if (!point) continue;
    const std::string label = highlight.label();
    const double width = font.width(label) + 2 * pad;
    const auto place = find_place(*point, width, font.line_height() + pad, layout.scene, taken);
    if (!place) continue;
    taken.push_back(*place);
    const Color color = mix(palette::kGround, palette::kOperator, highlight.strength());
    add_leader(view, *place, *point, color, overlay.shapes);
    // Dark letters on light, framed in the operators' colour: legible over any scene.
    add_rectangle_on_picture(overlay.shapes, view, *place, color);
    const double rim = 2;
    add_rectangle_on_picture(
        overlay.shapes, view,
        {place->left + rim, place->top + rim, place->width - 2 * rim, place->height - 2 * rim},
        palette::kGround);
    overlay.text.add(font, static_cast<int>(place->left) + pad, static_cast<int>(place->top) + pad, label,
                     palette::kInk);
  }
}

}  // namespace kerf
