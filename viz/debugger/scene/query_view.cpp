#include "viz/debugger/scene/query_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/base/overloaded.h"
#include "core/base/shortest_text.h"
#include "viz/debugger/scene/outline_box.h"
#include "viz/debugger/scene/ray.h"
#include "viz/draw/palette.h"
#include "viz/draw/strokes.h"

namespace kerf {
namespace {

constexpr double kVisited = 1.25;  // pixels of lines
constexpr double kInner = 0.35;    // opacity of those that are no leaves
constexpr double kPruned = 1;
constexpr double kFound = 2;
constexpr double kAsked = 2.5;
constexpr double kPoint = 5;
constexpr double kDash = 5;
constexpr std::size_t kMostNames = 6;  // more would hide the scene
constexpr std::size_t kMany = 20;      // thick lines of more would be one spot
constexpr int kCorners = 48;           // of a circle

template <int D>
Eigen::Vector3d along(const Ray<D>& ray, double t) {
  return to_point(ray.origin) + t * to_point(ray.direction);
}

/// t at which nothing of the scene is left.
template <int D>
double end_of(const DrawContext<D>& frame, const Ray<D>& ray) {
  const double speed = to_point(ray.direction).norm();
  const double size = (to_point(frame.bounds.max) - to_point(frame.bounds.min)).norm();
  const double way = (to_point(frame.bounds.center()) - to_point(ray.origin)).norm() + 0.6 * size;
  return speed > 0 ? std::min(way / speed, double{ray.max_t}) : 0;
}

template <int D>
void draw_visits(const DrawContext<D>& frame, const QueryExplanation<D>& e, Batch& batch) {
  const double scale = frame.line_scale;
  for (const bool visited : {false, true})
    for (const QueryVisit<D>& v : e.visits) {
      if ((v.visit.fate == NodeFate::visited) != visited || v.bounds.min[0] > v.bounds.max[0]) continue;
      const Color of_visited = with_alpha(palette::kSelected, v.is_leaf ? 1 : kInner);
      const Stroke stroke = visited
                                ? Stroke{of_visited, kVisited * scale}
                                : Stroke{palette::kFaintInk, kPruned * scale, kDash * scale, kDash * scale};
      outline_box(frame, v.bounds, stroke, batch);
    }
}

/// Solid as far as the tree looked.
template <int D>
void draw_asked(const DrawContext<D>& frame, const QueryExplanation<D>& e, const Ray<D>& ray, Batch& batch) {
  const double end = end_of(frame, ray);
  const double first = e.found.empty() ? end : e.found.front().key;
  const double scale = frame.line_scale;
  add_line(batch, frame.view, along(ray, first), along(ray, std::max(first, end)),
           {palette::kInk, kAsked * scale / 2, kDash * scale, kDash * scale});
  add_line(batch, frame.view, along(ray, 0), along(ray, first), {palette::kInk, kAsked * scale});
  add_diamond(batch, frame.view, along(ray, 0), kPoint * scale, palette::kInk);
  for (const FoundObject& found : e.found)
    add_diamond(batch, frame.view, along(ray, found.key), kPoint * scale, palette::kOperator);
}

template <int D>
void draw_asked(const DrawContext<D>& frame, const QueryExplanation<D>& /*e*/, const Box<D>& box,
                Batch& batch) {
  outline_box(frame, box, {palette::kInk, kAsked * frame.line_scale}, batch);
}

/// A circle in the plane of two axes.
template <int D>
void draw_circle(const DrawContext<D>& frame, const Sphere<D>& sphere, int first, int second, Batch& batch) {
  Polygon circle;
  for (int k = 0; k < kCorners; ++k) {
    const double angle = 2 * std::numbers::pi * k / kCorners;
    Eigen::Vector3d corner = to_point(sphere.center);
    corner[first] += double{sphere.radius} * std::cos(angle);
    corner[second] += double{sphere.radius} * std::sin(angle);
    circle.push_back(corner);
  }
  add_outline(batch, frame.view, circle, {palette::kInk, kAsked * frame.line_scale});
}

template <int D>
void draw_asked(const DrawContext<D>& frame, const QueryExplanation<D>& /*e*/, const Sphere<D>& sphere,
                Batch& batch) {
  if (sphere.radius == 0)
    return add_diamond(batch, frame.view, to_point(sphere.center), kPoint * frame.line_scale, palette::kInk);
  draw_circle(frame, sphere, 0, 1, batch);
  if constexpr (D == 3) {
    draw_circle(frame, sphere, 0, 2, batch);
    draw_circle(frame, sphere, 1, 2, batch);
  }
}

template <int D>
std::optional<Box<D>> box_of(std::span<const Body<D>> bodies, ObjectId object) {
  if (object.index() >= bodies.size() || !is_drawable(bodies[object.index()])) return std::nullopt;
  return bodies[object.index()].box;
}

/// The boxes of what was found.
template <int D>
void draw_found(const DrawContext<D>& frame, const QueryExplanation<D>& e, std::span<const Body<D>> bodies,
                Batch& batch) {
  const double width = e.found.size() > kMany ? 1 : kFound;
  for (const FoundObject& found : e.found)
    if (const auto box = box_of(bodies, found.object))
      outline_box(frame, *box, {palette::kOperator, width * frame.line_scale}, batch);
}

/// A line from the point to each box that was found, where it is nearest.
template <int D>
void draw_ways(const DrawContext<D>& frame, const QueryExplanation<D>& e, const Nearest<D>& nearest,
               std::span<const Body<D>> bodies, Batch& batch) {
  const Eigen::Vector3d point = to_point(nearest.point);
  for (const FoundObject& found : e.found)
    if (const auto box = box_of(bodies, found.object)) {
      const Eigen::Vector3d to = point.cwiseMax(to_point(box->min)).cwiseMin(to_point(box->max));
      add_line(batch, frame.view, point, to, {palette::kOperator, kFound * frame.line_scale});
    }
  add_diamond(batch, frame.view, point, kPoint * frame.line_scale, palette::kInk);
}

/// Texts at both places would lie on each other.
bool is_near(const Eigen::Vector2d& at, std::span<const Eigen::Vector2d> taken, double scale) {
  constexpr double kWide = 34;
  constexpr double kHigh = 18;
  return std::ranges::any_of(taken, [&](const Eigen::Vector2d& other) {
    return std::abs(at.x() - other.x()) < kWide * scale && std::abs(at.y() - other.y()) < kHigh * scale;
  });
}

/// "1,2,": as many numbers as there are axes.
template <int D>
std::string coordinates(const Eigen::Vector3d& v) {
  std::string text;
  for (int i = 0; i < D; ++i) text += shortest_text(static_cast<Scalar>(v[i])) + ",";
  return text;
}

}  // namespace

template <int D>
std::string query_through(const View& view, double x, double y) {
  const SightRay sight = ray_through(view, x, y);
  if (D == 2) return "sphere " + coordinates<D>(sight.start) + "0";
  std::string ray = "ray " + coordinates<D>(sight.start) + coordinates<D>(sight.way.normalized());
  ray.pop_back();
  return ray;
}

template <int D>
std::vector<PlacedText> draw_query(const DrawContext<D>& frame, const QueryExplanation<D>& e,
                                   std::span<const Body<D>> bodies, const GivenNames& names, Batch& front) {
  std::vector<PlacedText> texts;
  if (e.status != QueryStatus::ok) return texts;
  draw_visits(frame, e, front);
  draw_found(frame, e, bodies, front);
  std::visit(Overloaded{[&](const Nearest<D>& nearest) { draw_ways(frame, e, nearest, bodies, front); },
                        [&](const auto& asked) { draw_asked(frame, e, asked, front); }},
             e.query);
  std::vector<Eigen::Vector2d> taken;
  for (const FoundObject& found : e.found) {
    const auto box = box_of(bodies, found.object);
    const auto at = box ? frame.view.project(to_point(box->max)) : std::nullopt;
    if (!at || texts.size() == kMostNames || is_near(*at, taken, frame.line_scale)) continue;
    taken.push_back(*at);
    texts.emplace_back(to_point(box->max), names.object(found.object));
  }
  return texts;
}

template std::string query_through<2>(const View&, double, double);
template std::string query_through<3>(const View&, double, double);
template std::vector<PlacedText> draw_query(const DrawContext<2>&, const QueryExplanation<2>&,
                                            std::span<const Body<2>>, const GivenNames&, Batch&);
template std::vector<PlacedText> draw_query(const DrawContext<3>&, const QueryExplanation<3>&,
                                            std::span<const Body<3>>, const GivenNames&, Batch&);

}  // namespace kerf
