#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "viz/draw/letters.h"
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

/// A highlight that the picture can name, and the place of its label.
struct Label {
  const Highlight* of;
  Eigen::Vector2d point;
  std::string text;
  Viewport place{};
};

/// Those whose points lie before the camera, the newest first.
std::vector<Label> find_labels(const View& view, const std::vector<Highlight>& highlights) {
  std::vector<Label> labels;
  for (const Highlight& highlight : highlights) {
    const auto point = highlight.anchor ? view.project(*highlight.anchor) : std::nullopt;
    if (point) labels.push_back({&highlight, *point, highlight.label()});
  }
  return labels;
}

int padding_of_label(const Font& font) { return std::max(4, 3 * font.advance() / 4); }

/// Those that have room, the oldest first: it chooses first, so that no label of a film makes way for a newer
/// one.
std::vector<Label> place_labels(const Font& font, const Viewport& scene, std::span<const Label> labels) {
  const int pad = padding_of_label(font);
  std::vector<Label> placed;
  std::vector<Viewport> taken;
  for (auto label = labels.rbegin(); label != labels.rend(); ++label) {
    const std::string text = shortened(label->text, font.letters(static_cast<int>(scene.width) - 4 * pad));
    const double width = font.width(text) + 2 * pad;
    const auto place = find_place(label->point, width, font.line_height() + pad, scene, taken);
    if (!place) continue;
    taken.push_back(*place);
    placed.push_back(*label);
    placed.back().place = *place;
    placed.back().text = text;
  }
  return placed;
}

/// Where there is no room for all, the oldest are left out until the newest has a place.
std::vector<Label> place_newest(const Font& font, const Viewport& scene, const std::vector<Label>& labels) {
  for (std::size_t kept = labels.size(); kept > 0; --kept) {
    std::vector<Label> placed = place_labels(font, scene, std::span(labels).first(kept));
    if (!placed.empty() && placed.back().of == labels.front().of) return placed;
  }
  return {};
}

/// Dark letters on light, framed in the operators' colour: legible over any scene.
void draw_label(const View& view, const Font& font, const Label& label, Overlay& overlay) {
  const double rim = 2;
  const Viewport& place = label.place;
  const Color color = mix(palette::kGround, palette::kOperator, label.of->strength());
  add_leader(view, place, label.point, color, overlay.shapes);
  add_rectangle_on_picture(overlay.shapes, view, place, color);
  add_rectangle_on_picture(overlay.shapes, view,
                           {place.left + rim, place.top + rim, place.width - 2 * rim, place.height - 2 * rim},
                           palette::kGround);
  const int pad = padding_of_label(font);
  overlay.text.add(font, static_cast<int>(place.left) + pad, static_cast<int>(place.top) + pad, label.text,
                   palette::kInk);
}

}  // namespace

void draw_highlight_labels(const View& view, const Font& font, const Layout& layout,
                           const std::vector<Highlight>& highlights, Overlay& overlay) {
  for (const Label& label : place_newest(font, layout.scene, find_labels(view, highlights)))
    draw_label(view, font, label, overlay);
}

}  // namespace kerf
