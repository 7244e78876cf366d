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

/// Where the eye looks for the operator: the middle of its partitioner, or else of its cell.
std::optional<Eigen::Vector2d> anchor(const View& view, const Highlight& highlight) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double count = 0;
  const auto add = [&](const Polygon& polygon) {
    for (const Eigen::Vector3d& p : polygon) sum += p;
    count += static_cast<double>(polygon.size());
  };
  add(highlight.partitioner);
  if (count == 0) add(highlight.old_partitioner);
  if (count == 0) std::ranges::for_each(highlight.faces, add);
  if (count == 0) return std::nullopt;
  return view.project(sum / count);
}

/// A place for a label near `wanted`, within the scene's part of the picture and clear of the others.
std::optional<Viewport> find_place(const Viewport& wanted, const Viewport& scene,
                                   const std::vector<Viewport>& taken) {
  const auto clamped = [&](Viewport box) {
    box.left = std::round(
        std::clamp(box.left, scene.left, std::max(scene.left, scene.left + scene.width - box.width)));
    box.top = std::round(
        std::clamp(box.top, scene.top, std::max(scene.top, scene.top + scene.height - box.height)));
    return box;
  };
  for (int ring = 0; ring < 12; ++ring) {
    for (const int sign : {-1, 1}) {
      const Viewport box =
          clamped({wanted.left, wanted.top + sign * ring * (wanted.height + 2), wanted.width, wanted.height});
      if (std::ranges::none_of(taken, [&](const Viewport& other) { return overlap(box, other); })) return box;
    }
  }
  return std::nullopt;
}

}  // namespace

void draw_highlight_labels(const View& view, const Font& font, const Layout& layout,
                           const std::vector<Highlight>& highlights, Overlay& overlay) {
  const int pad = std::max(4, 3 * font.advance() / 4);
  std::vector<Viewport> taken;
  for (const Highlight& highlight : highlights) {
    const auto point = anchor(view, highlight);
    if (!point) continue;
    const std::string label = highlight.label();
    const double width = font.width(label) + 2 * pad;
    const double height = font.line_height() + pad;
    const auto place =
        find_place({point->x() - width / 2, point->y() - height / 2, width, height}, layout.scene, taken);
    if (!place) continue;
    taken.push_back(*place);
    // Dark letters on light, framed in the operators' colour: legible over any scene.
    add_rectangle_on_picture(overlay.shapes, view, *place,
                             mix(palette::kGround, palette::kOperator, highlight.strength()));
    const double rim = 2;
    add_rectangle_on_picture(overlay.shapes, view,
                             {place->left + rim, place->top + rim, width - 2 * rim, height - 2 * rim},
                             palette::kGround);
    overlay.text.add(font, static_cast<int>(place->left) + pad, static_cast<int>(place->top) + pad, label,
                     palette::kInk);
  }
}

}  // namespace kerf
