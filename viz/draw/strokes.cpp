#include "viz/draw/strokes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

namespace kerf {
namespace {

/// A point on the picture: pixels, and the depth that the rasteriser compares.
struct Spot {
  double x, y, depth;
};

Spot between(const Spot& a, const Spot& b, double t) {
  return {a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t, a.depth + (b.depth - a.depth) * t};
}

Spot spot(const View& view, const Eigen::Vector4d& clip) {
  return {0.5 * (clip.x() / clip.w() + 1) * view.picture_width,
          0.5 * (clip.y() / clip.w() + 1) * view.picture_height, clip.z() / clip.w()};
}

std::uint32_t add_spot(Batch& batch, const View& view, double x, double y, double depth, Color color) {
  return batch.add_vertex({2 * x / view.picture_width - 1, 2 * y / view.picture_height - 1, depth, 1}, color);
}

struct Segment {
  Spot a, b;
};

/// Cuts [t0, t1] to the part where p + q * t >= 0.
void cut(double p, double q, double& t0, double& t1) {
  if (q == 0) {
    if (p < 0) t1 = -1;
  } else if (q > 0) {
    t0 = std::max(t0, -p / q);
  } else {
    t1 = std::min(t1, -p / q);
  }
}

/// The part of a segment on the picture, a little border included (Liang and Barsky 1984).
std::optional<Segment> cut_to_picture(const View& view, const Segment& s, double border) {
  double t0 = 0;
  double t1 = 1;
  const double dx = s.b.x - s.a.x;
  const double dy = s.b.y - s.a.y;
  cut(s.a.x + border, dx, t0, t1);
  cut(view.picture_width + border - s.a.x, -dx, t0, t1);
  cut(s.a.y + border, dy, t0, t1);
  cut(view.picture_height + border - s.a.y, -dy, t0, t1);
  if (t0 > t1) return std::nullopt;
  return Segment{between(s.a, s.b, t0), between(s.a, s.b, t1)};
}

std::optional<Segment> project_segment(const View& view, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  Eigen::Vector4d p = view.clip_from_world * a.homogeneous();
  Eigen::Vector4d q = view.clip_from_world * b.homogeneous();
  if (view.perspective) {
    double t0 = 0;
    double t1 = 1;
    cut(p.w() - view.near, q.w() - p.w(), t0, t1);
    if (t0 > t1) return std::nullopt;
    const Eigen::Vector4d d = q - p;
    q = p + d * t1;
    p += d * t0;
  }
  return Segment{spot(view, p), spot(view, q)};
}

/// One solid bar from t0 to t1 along a segment; `nx`, `ny`: half the width across it.
void add_bar(Batch& batch, const View& view, const Segment& s, double nx, double ny, Color color) {
  const std::uint32_t first = add_spot(batch, view, s.a.x - nx, s.a.y - ny, s.a.depth, color);
  add_spot(batch, view, s.a.x + nx, s.a.y + ny, s.a.depth, color);
  add_spot(batch, view, s.b.x + nx, s.b.y + ny, s.b.depth, color);
  add_spot(batch, view, s.b.x - nx, s.b.y - ny, s.b.depth, color);
  batch.add_triangle(first, first + 1, first + 2);
  batch.add_triangle(first, first + 2, first + 3);
}

void stroke_segment(Batch& batch, const View& view, const Segment& whole, const Stroke& stroke) {
  const std::optional<Segment> seen = cut_to_picture(view, whole, 2 * stroke.width);
  if (!seen) return;
  const double dx = seen->b.x - seen->a.x;
  const double dy = seen->b.y - seen->a.y;
  const double length = std::sqrt(dx * dx + dy * dy);
  if (!(length > 1e-3)) return;
  const double nx = -dy / length * 0.5 * stroke.width;
  const double ny = dx / length * 0.5 * stroke.width;
  if (stroke.dash <= 0) {
    add_bar(batch, view, *seen, nx, ny, stroke.color);
    return;
  }
  const double period = (stroke.dash + stroke.gap) / length;
  const double part = stroke.dash / length;
  for (double t = 0; t < 1; t += period) {
    const Segment dash{between(seen->a, seen->b, t), between(seen->a, seen->b, std::min(1.0, t + part))};
    add_bar(batch, view, dash, nx, ny, stroke.color);
  }
}

void add_diamond_at(Batch& batch, const View& view, const Spot& s, double radius, Color color) {
  const std::uint32_t first = add_spot(batch, view, s.x - radius, s.y, s.depth, color);
  add_spot(batch, view, s.x, s.y - radius, s.depth, color);
  add_spot(batch, view, s.x + radius, s.y, s.depth, color);
  add_spot(batch, view, s.x, s.y + radius, s.depth, color);
  batch.add_triangle(first, first + 1, first + 2);
  batch.add_triangle(first, first + 2, first + 3);
}

}  // namespace

void add_line(Batch& batch, const View& view, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
              const Stroke& stroke) {
  if (const auto segment = project_segment(view, a, b)) stroke_segment(batch, view, *segment, stroke);
}

void add_outline(Batch& batch, const View& view, std::span<const Eigen::Vector3d> corners,
                 const Stroke& stroke) {
  const std::size_t edges = corners.size() == 2 ? 1 : corners.size();
  for (std::size_t i = 0; i < edges; ++i)
    add_line(batch, view, corners[i], corners[(i + 1) % corners.size()], stroke);
}

void add_polygon(Batch& batch, const View& view, std::span<const Eigen::Vector3d> corners, Color color) {
  thread_local std::vector<Eigen::Vector4d> clip;
  clip.clear();
  for (const Eigen::Vector3d& corner : corners)
    clip.emplace_back(view.clip_from_world * corner.homogeneous());
  batch.add_fan(clip, color);
}

void add_diamond(Batch& batch, const View& view, const Eigen::Vector3d& center, double radius, Color color) {
  const Eigen::Vector4d clip = view.clip_from_world * center.homogeneous();
  if (view.perspective && clip.w() <= view.near) return;
  add_diamond_at(batch, view, spot(view, clip), radius, color);
}

void add_line_on_picture(Batch& batch, const View& view, const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                         const Stroke& stroke) {
  stroke_segment(batch, view, {{a.x(), a.y(), 0}, {b.x(), b.y(), 0}}, stroke);
}

void add_diamond_on_picture(Batch& batch, const View& view, const Eigen::Vector2d& center, double radius,
                            Color color) {
  add_diamond_at(batch, view, {center.x(), center.y(), 0}, radius, color);
}

void add_rectangle_on_picture(Batch& batch, const View& view, const Viewport& r, Color color) {
  const double middle = r.top + 0.5 * r.height;
  add_bar(batch, view, {{r.left, middle, 0}, {r.left + r.width, middle, 0}}, 0, 0.5 * r.height, color);
}

}  // namespace kerf
