#pragma once

#include <Eigen/Core>
#include <span>

#include "viz/draw/batch.h"
#include "viz/draw/camera.h"

namespace kerf {

/// How a line is drawn. Lengths are pixels.
struct Stroke {
  Color color;
  double width = 1;
  double dash = 0;  ///< length of a dash; 0: solid
  double gap = 0;   ///< between dashes
};

/// A line between two scene points, as wide on the picture everywhere. Parts behind the eye or outside of the
/// picture are left out.
void add_line(Batch& batch, const View& view, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
              const Stroke& stroke);

/// The closed outline of a polygon; of two points, the line between them.
void add_outline(Batch& batch, const View& view, std::span<const Eigen::Vector3d> corners,
                 const Stroke& stroke);

/// A filled convex polygon.
void add_polygon(Batch& batch, const View& view, std::span<const Eigen::Vector3d> corners, Color color);

/// A filled diamond of `radius` pixels around a scene point.
void add_diamond(Batch& batch, const View& view, const Eigen::Vector3d& center, double radius, Color color);

/// The same in pixel coordinates, in front of everything.
void add_line_on_picture(Batch& batch, const View& view, const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                         const Stroke& stroke);
void add_diamond_on_picture(Batch& batch, const View& view, const Eigen::Vector2d& center, double radius,
                            Color color);
void add_rectangle_on_picture(Batch& batch, const View& view, const Viewport& rectangle, Color color);

}  // namespace kerf
