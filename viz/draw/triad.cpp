#include "viz/draw/triad.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <string_view>

#include "viz/draw/palette.h"
#include "viz/draw/strokes.h"

namespace kerf {
namespace {

struct Axis {
  std::string_view name;
  Color color;
};
constexpr std::array<Axis, 3> kAxes{
    {{"x", palette::kSeries[1]}, {"y", palette::kSeries[2]}, {"z", palette::kSeries[0]}}};
constexpr double kFromEdge = 1.7;   ///< lengths between the origin and the edges of the part
constexpr double kToLetter = 0.28;  ///< lengths between an axis and its name

}  // namespace

void draw_triad(const View& view, const Font& font, const Viewport& part, Corner corner, double length,
                Overlay& overlay) {
  const double away = kFromEdge * length;
  const Eigen::Vector2d origin(corner == Corner::left ? part.left + away : part.left + part.width - away,
                               part.top + part.height - away);
  const Eigen::Vector3d up = view.right.cross(view.forward);
  std::array<int, 3> order{0, 1, 2};
  std::ranges::stable_sort(order, [&](int a, int b) { return view.forward[a] > view.forward[b]; });
  for (const int i : order) {
    const Axis& axis = kAxes[static_cast<std::size_t>(i)];
    const Eigen::Vector2d way(view.right[i], -up[i]);
    const Eigen::Vector2d end = origin + length * way;
    add_line_on_picture(overlay.shapes, view, origin, end, {axis.color, 0.07 * length});
    add_diamond_on_picture(overlay.shapes, view, end, 0.09 * length, axis.color);
    const double seen = way.norm();
    if (seen < 0.2) continue;  // it points at the viewer, and its name would lie on the others
    const Eigen::Vector2d letter = end + kToLetter * length / seen * way;
    overlay.text.add(font, static_cast<int>(letter.x()) - font.width(axis.name) / 2,
                     static_cast<int>(letter.y()) - font.line_height() / 2, axis.name, palette::kInk);
  }
}

}  // namespace kerf
