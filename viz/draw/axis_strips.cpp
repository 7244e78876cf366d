#include "viz/draw/axis_strips.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "viz/draw/clip.h"
#include "viz/draw/palette.h"
#include "viz/draw/strokes.h"
#include "viz/draw/structure_draw.h"

namespace kerf {
namespace {

double row_height(const Font& font) { return 1.5 * font.line_height(); }

/// A strip from `begin` to `end` pixels along its axis; `place` takes a coordinate to a pixel.
struct Strip {
  double begin = 0;
  double end = 0;
  double origin = 0;  ///< pixels at coordinate 0
  double scale = 1;   ///< pixels of a unit; negative: upwards
  [[nodiscard]] double place(double x) const { return std::clamp(origin + scale * x, begin, end); }
};

/// How many objects are open at each pixel of the strip.
template <int D>
std::vector<std::uint32_t> open_at(const Strip& strip, const AxisList& list,
                                   std::span<const Body<D>> bodies) {
  const auto pixels = static_cast<std::size_t>(std::max(1.0, std::ceil(strip.end - strip.begin)));
  std::vector<std::int64_t> change(pixels + 1, 0);
  for (const AxisEnd& end : list.ends) {
    if (end.upper || end.object.index() >= bodies.size()) continue;
    const Box<D>& box = bodies[end.object.index()].box;
    const double a = strip.place(box.min[list.axis]) - strip.begin;
    const double b = strip.place(box.max[list.axis]) - strip.begin;
    const auto from = static_cast<std::size_t>(std::min(a, b));
    const auto to = static_cast<std::size_t>(std::max(a, b));
    ++change[std::min(from, pixels)];
    --change[std::min(to + 1, pixels)];
  }
  std::vector<std::uint32_t> open(pixels, 0);
  std::int64_t now = 0;
  for (std::size_t k = 0; k < pixels; ++k) {
    now += change[k];
    open[k] = static_cast<std::uint32_t>(now);
  }
  return open;
}

double height_of(std::uint32_t open, std::size_t objects, double room) {
  return room * std::log2(1.0 + open) / std::log2(2.0 + static_cast<double>(objects));
}

std::string axis_name(int axis) { return std::string(1, static_cast<char>('x' + axis)); }

template <int D>
class StripPainter {
 public:
  StripPainter(const View& view, const Font& font, std::span<const Body<D>> bodies, Overlay& overlay)
      : view_(view), font_(font), bodies_(bodies), overlay_(overlay) {}

  void across(const AxisList& list, const Strip& strip, double top) {
    const double room = row_height(font_) - 3;
    const double base = top + room + 1;
    const auto open = open_at(strip, list, bodies_);
    runs(open, [&](std::size_t from, std::size_t to) {
      const double height = height_of(open[from], bodies_.size(), room);
      rectangle({strip.begin + double(from), base - height, double(to - from), height});
    });
    line(base, strip.begin, strip.end, true);
    name(list.axis, static_cast<int>(strip.begin) + 2, static_cast<int>(top));
  }

  void upright(const AxisList& list, const Strip& strip, double left) {
    const double room = row_height(font_) - 3;
    const auto open = open_at(strip, list, bodies_);
    runs(open, [&](std::size_t from, std::size_t to) {
      const double height = height_of(open[from], bodies_.size(), room);
      rectangle({left + 1 + room - height, strip.begin + double(from), height, double(to - from)});
    });
    line(left + room + 1, strip.begin, strip.end, false);
    name(list.axis, static_cast<int>(left) + 2, static_cast<int>(strip.begin) + 2);
  }

 private:
  /// Calls `draw` for each run of equal heights that are not 0.
  template <class Draw>
  static void runs(const std::vector<std::uint32_t>& open, Draw draw) {
    for (std::size_t from = 0; from < open.size();) {
      std::size_t to = from + 1;
      while (to < open.size() && open[to] == open[from]) ++to;
      if (open[from] != 0) draw(from, to);
      from = to;
    }
  }
  void rectangle(const Viewport& box) {
    add_rectangle_on_picture(overlay_.shapes, view_, box, with_alpha(kAxisStrip, 0.45));
  }
  void line(double at, double from, double to, bool is_level) {
    const Eigen::Vector2d a = is_level ? Eigen::Vector2d(from, at) : Eigen::Vector2d(at, from);
    const Eigen::Vector2d b = is_level ? Eigen::Vector2d(to, at) : Eigen::Vector2d(at, to);
    add_line_on_picture(overlay_.shapes, view_, a, b, {kAxisStrip, 1});
  }
  void name(int axis, int x, int y) { overlay_.text.add(font_, x, y, axis_name(axis), palette::kInk); }

  const View& view_;
  const Font& font_;
  std::span<const Body<D>> bodies_;
  Overlay& overlay_;
};

}  // namespace

StripRoom strip_room(int dimension, const Font& font) {
  const double row = row_height(font);
  return dimension == 2 ? StripRoom{row, row} : StripRoom{0, 3 * row};
}

template <int D>
void draw_axis_strips(const View& view, const Font& font, const Viewport& scene, const Box<D>& bounds,
                      std::span<const AxisList> lists, std::span<const Body<D>> bodies, Overlay& overlay) {
  StripPainter<D> painter(view, font, bodies, overlay);
  const double row = row_height(font);
  const double below = scene.top + scene.height;
  for (const AxisList& list : lists) {
    if constexpr (D == 2) {
      const auto middle = to_point(bounds.center());
      const auto at = view.project(middle);
      const double unit = view.pixels_per_unit_at_one;
      if (!at) continue;
      if (list.axis == 0) {
        painter.across(list, {scene.left, scene.left + scene.width, at->x() - unit * middle.x(), unit},
                       below);
      } else {
        painter.upright(list, {scene.top, scene.top + scene.height, at->y() + unit * middle.y(), -unit},
                        scene.left - row);
      }
    } else {
      const double low = bounds.min[list.axis];
      const double scale = scene.width / std::max(1e-30, double{bounds.max[list.axis]} - low);
      painter.across(list, {scene.left, scene.left + scene.width, scene.left - scale * low, scale},
                     below + row * list.axis);
    }
  }
}

template void draw_axis_strips(const View&, const Font&, const Viewport&, const Box<2>&,
                               std::span<const AxisList>, std::span<const Body<2>>, Overlay&);
template void draw_axis_strips(const View&, const Font&, const Viewport&, const Box<3>&,
                               std::span<const AxisList>, std::span<const Body<3>>, Overlay&);

}  // namespace kerf
