#include <algorithm>

#include "viz/draw/draw_context.h"
#include "viz/draw/palette.h"
#include "viz/draw/strokes.h"

namespace kerf {
namespace {

// The line to an object this many times larger than its partner ends where the object begins, not at its
// middle.
constexpr double kLarge = 3;
constexpr double kLargeFixed = 1.5;

template <int D>
double largest_extent(const Box<D>& box) {
  const Vector<D> extent = box.extent();
  double largest = 0;
  for (int i = 0; i < D; ++i) largest = std::max(largest, double{extent[i]});
  return largest;
}

/// Where `small` meets `large`: the middle of their overlap, or its bottom when that is the middle of
/// `small`. The middle of the ground may be far away, and a thousand lines to it would hide everything.
template <int D>
Eigen::Vector3d meeting_point(const Box<D>& small, const Box<D>& large) {
  Box<D> common;
  for (int i = 0; i < D; ++i) {
    common.min[i] = std::max(small.min[i], large.min[i]);
    common.max[i] = std::max(common.min[i], std::min(small.max[i], large.max[i]));
  }
  Eigen::Vector3d point = to_point(common.center());
  const Eigen::Vector3d offset = point - to_point(small.center());
  if (offset.norm() < 0.15 * largest_extent(small)) point.y() = double{common.min[1]};
  return point;
}

struct Line {
  Eigen::Vector3d a, b;
};

template <int D>
bool is_large(const Body<D>& body, const Body<D>& partner) {
  const double ratio = body.mobility == Mobility::fixed ? kLargeFixed : kLarge;
  return largest_extent(body.box) > ratio * largest_extent(partner.box);
}

template <int D>
Line line_between(const Body<D>& a, const Body<D>& b) {
  Line line{to_point(a.box.center()), to_point(b.box.center())};
  if (is_large(b, a)) {
    line.b = meeting_point(a.box, b.box);
  } else if (is_large(a, b)) {
    line.a = meeting_point(b.box, a.box);
  }
  return line;
}

/// In 3D the middles of touching objects lie inside of them. The line is moved towards the eye, just out of
/// the smaller object, so that it is seen where the objects are seen and hidden where they are hidden.
Eigen::Vector3d towards_eye(const View& view, const Eigen::Vector3d& p, double distance) {
  const Eigen::Vector3d way = view.eye - p;
  const double length = way.norm();
  return length > 0 ? Eigen::Vector3d(p + way * std::min(0.5, distance / length)) : p;
}

template <int D>
Line seen_line(const View& view, const Body<D>& a, const Body<D>& b) {
  Line line = line_between(a, b);
  if (D == 2) return line;
  const double lift = 0.9 * std::min(largest_extent(a.box), largest_extent(b.box));
  return {towards_eye(view, line.a, lift), towards_eye(view, line.b, lift)};
}

template <int D>
void draw_pair(const DrawContext<D>& context, const Pair& pair, bool is_contact, Batch& batch) {
  const auto bodies = context.input.bodies;
  if (pair.a.index() >= bodies.size() || pair.b.index() >= bodies.size()) return;
  const Body<D>& a = bodies[pair.a.index()];
  const Body<D>& b = bodies[pair.b.index()];
  if (!is_drawable(a) || !is_drawable(b)) return;
  context.begin(batch, DrawnKind::pair, pair.a.value, pair.b.value);
  const Line line = seen_line(context.view, a, b);
  const Eigen::Vector3d middle = 0.5 * (line.a + line.b);
  const double pixels =
      std::min(largest_extent(a.box), largest_extent(b.box)) * context.view.pixels_per_unit(middle);
  const double scale = context.line_scale;
  if (is_contact) {
    add_line(batch, context.view, line.a, line.b,
             {palette::kContact, scale * std::clamp(pixels / 20, 0.9, 2.0)});
    add_diamond(batch, context.view, middle, scale * std::clamp(pixels / 9, 1.6, 4.0), palette::kContact);
  } else {
    const double width = scale * std::clamp(pixels / 20, 0.9, 1.4);
    add_line(batch, context.view, line.a, line.b, {palette::kCandidate, width, 4 * scale, 3 * scale});
  }
}

}  // namespace

template <int D>
std::pair<Eigen::Vector3d, Eigen::Vector3d> pair_line(const View& view, const Body<D>& a, const Body<D>& b) {
  const Line line = seen_line(view, a, b);
  return {line.a, line.b};
}

template <int D>
void draw_pairs(const DrawContext<D>& context, Batch& batch) {
  const auto contacts = context.has(Layer::contacts) ? context.input.contacts : std::span<const Pair>();
  if (context.has(Layer::pairs)) {
    for (const Pair& pair : context.input.pairs)
      if (!std::ranges::binary_search(contacts, pair)) draw_pair(context, pair, false, batch);
  }
  for (const Pair& pair : contacts) draw_pair(context, pair, true, batch);
}

template std::pair<Eigen::Vector3d, Eigen::Vector3d> pair_line(const View&, const Body<2>&, const Body<2>&);
template std::pair<Eigen::Vector3d, Eigen::Vector3d> pair_line(const View&, const Body<3>&, const Body<3>&);
template void draw_pairs<2>(const DrawContext<2>&, Batch&);
template void draw_pairs<3>(const DrawContext<3>&, Batch&);

}  // namespace kerf
