#pragma once

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <variant>

#include "core/base/overloaded.h"
#include "core/scene/scene.h"
#include "viz/draw/draw_context.h"

namespace kerf {

/// From the middle to the side of the least body that is drawn, in units of the scene: a disc of so many
/// pixels covers the centre of one wherever it lies. Else most objects that are smaller than a pixel would
/// not be seen, and in 2D of a thin one only pieces.
template <int D>
double least_half(const DrawContext<D>& context, double pixels_per_unit) {
  constexpr double kPixels = 0.75;
  return kPixels * std::max(1.0, context.line_scale) / pixels_per_unit;
}

/// From the middle of a dot to its rim, in pixels of a picture of 720 rows.
inline constexpr double kDotPixels = 3;

/// Whether a body is a point to the eye. It is drawn as a dot with a rim: the least shape, two pixels in a
/// colour of its own, is not found among the colours of leaves.
template <int D>
bool is_point(const Box<D>& box, double pixels_per_unit) {
  constexpr double kPixels = 1.0 / 16;
  const Vector<D> extent = box.extent();
  return double{*std::ranges::max_element(extent.value)} * pixels_per_unit < kPixels;
}

/// The radius of its dot, in units of the scene.
template <int D>
double dot_radius(const DrawContext<D>& context, double pixels_per_unit) {
  return kDotPixels * std::max(1.0, context.line_scale) / pixels_per_unit;
}

/// A rectangle with its middle in the box's, `half` wide from there to each side, as the body would draw it.
inline Outline outline_in_box(const Body<2>& body, const Vector<2>& half) {
  Outline outline;
  for (const auto& [right, up] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
    Vector<2> way = body.box.center() - body.pose.position;
    way[0] += static_cast<Scalar>(right) * half[0];
    way[1] += static_cast<Scalar>(up) * half[1];
    const auto along = [&](const Vector<2>& axis) { return way[0] * axis[0] + way[1] * axis[1]; };
    outline.corners.push_back({{along(body.pose.axes[0]), along(body.pose.axes[1])}});
  }
  return outline;
}

/// The shape in which a body is drawn where its own is thinner than twice `half`; nothing where its own will
/// do. In 3D a body that is long, too, stays as it is, since its parts are not equally far from the eye; and
/// so do surfaces, and outlines that are long and thin.
template <int D>
std::optional<Shape<D>> least_shape(const Body<D>& body, double half) {
  constexpr Scalar kLong = D == 2 ? std::numeric_limits<Scalar>::infinity() : 25;  // of the least ones
  using Answer = std::optional<Shape<D>>;
  const auto least = static_cast<Scalar>(half);
  const auto widened = [least](const Vector<D>& own) {
    Brick<D> wide;
    for (int i = 0; i < D; ++i) wide.half[i] = std::max(own[i], least);
    return wide;
  };
  return std::visit(
      Overloaded{
          [&](const Ball& ball) { return ball.radius < least ? Answer(widened({})) : Answer(); },
          [&](const Brick<D>& brick) {
            const Brick<D> wide = widened(brick.half);
            const bool is_long = *std::ranges::max_element(wide.half.value) > kLong * least;
            return wide == brick || is_long ? Answer() : Answer(wide);
          },
          [&](const Outline&) {
            const Brick<D> wide = widened(body.box.extent() * 0.5F);
            if constexpr (D == 2)
              if (wide == widened({})) return Answer(outline_in_box(body, wide.half));
            return Answer();
          },
          [](const std::shared_ptr<const Surface>&) { return Answer(); },
      },
      body.shape);
}

}  // namespace kerf
