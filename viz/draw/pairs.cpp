#include <algorithm>
#include <optional>
#include <vector>

#include "viz/draw/draw_context.h"
#include "viz/draw/pair_density.h"
#include "viz/draw/palette.h"
#include "viz/draw/strokes.h"

namespace kerf {
namespace {

// The line to an object this many times larger than its partner ends where the object begins, not at its
// middle.
constexpr double kLarge = 3;
constexpr double kLargeFixed = 0.5;

constexpr double kThinnest = 0.7;        ///< pixels of a line that has faded
constexpr double kWeakestDiamond = 0.6;  ///< fainter contacts have no marker

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

/// A pair's line, measured before any is drawn: how strong it is depends on the others around it.
struct SeenPair {
  Pair pair;
  bool is_contact = false;
  Line line;
  std::optional<Eigen::Vector2d> middle;  ///< on the picture
  double length = 0;                      ///< pixels
  double size = 0;                        ///< of the smaller object, in pixels
};

double width_of(const SeenPair& seen, double scale) {
  return scale * std::clamp(seen.size / 20, 0.9, seen.is_contact ? 2.0 : 1.4);
}

template <int D>
void measure_pair(const DrawContext<D>& context, const Pair& pair, bool is_contact,
                  std::vector<SeenPair>& all) {
  const auto bodies = context.input.bodies;
  if (pair.a.index() >= bodies.size() || pair.b.index() >= bodies.size()) return;
  const Body<D>& a = bodies[pair.a.index()];
  const Body<D>& b = bodies[pair.b.index()];
  if (!is_drawable(a) || !is_drawable(b)) return;
  const View& view = context.view;
  SeenPair seen{pair, is_contact, seen_line(view, a, b), std::nullopt, 0, 0};
  const Eigen::Vector3d middle = 0.5 * (seen.line.a + seen.line.b);
  const double unit = view.pixels_per_unit(middle);
  seen.middle = view.project(middle);
  seen.length = (seen.line.b - seen.line.a).norm() * unit;
  seen.size = std::min(largest_extent(a.box), largest_extent(b.box)) * unit;
  all.push_back(seen);
}

template <int D>
void draw_pair(const DrawContext<D>& context, const SeenPair& seen, double strength, Batch& batch) {
  context.begin(batch, DrawnKind::pair, seen.pair.a.value, seen.pair.b.value);
  const double scale = context.line_scale;
  const double width = std::max(kThinnest * scale, strength * width_of(seen, scale));
  const Line& line = seen.line;
  if (seen.is_contact) {
    const Color color = with_alpha(palette::kContact, strength);
    add_line(batch, context.view, line.a, line.b, {color, width});
    if (strength < kWeakestDiamond || context.brief) return;
    const double radius = scale * strength * std::clamp(seen.size / 9, 1.6, 4.0);
    add_diamond(batch, context.view, 0.5 * (line.a + line.b), radius, color);
  } else {
    const Color color = with_alpha(palette::kCandidate, strength);
    const double dash = context.brief ? 0 : 4 * scale;
    add_line(batch, context.view, line.a, line.b, {color, width, dash, 3 * scale});
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
  std::vector<SeenPair> all;
  if (context.has(Layer::pairs)) {
    for (const Pair& pair : context.input.pairs)
      if (!std::ranges::binary_search(contacts, pair)) measure_pair(context, pair, false, all);
  }
  for (const Pair& pair : contacts) measure_pair(context, pair, true, all);
  PairDensity density(context.view);
  for (const SeenPair& seen : all)
    if (seen.middle) density.add(*seen.middle, seen.length * width_of(seen, context.line_scale));
  for (const SeenPair& seen : all)
    draw_pair(context, seen, seen.middle ? density.strength(*seen.middle) : 1.0, batch);
}

template std::pair<Eigen::Vector3d, Eigen::Vector3d> pair_line(const View&, const Body<2>&, const Body<2>&);
template std::pair<Eigen::Vector3d, Eigen::Vector3d> pair_line(const View&, const Body<3>&, const Body<3>&);
template void draw_pairs<2>(const DrawContext<2>&, Batch&);
template void draw_pairs<3>(const DrawContext<3>&, Batch&);

}  // namespace kerf
