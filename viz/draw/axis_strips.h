#pragma once

#include <span>

#include "core/objects/structure.h"
#include "core/scene/scene.h"
#include "viz/draw/font.h"
#include "viz/draw/overlay.h"

namespace kerf {

/// Where lists along axes are drawn beside a scene: in 2D below it and to its left, where they lie along the
/// scene's own axes; in 3D three rows below it.
struct StripRoom {
  double left = 0;
  double bottom = 0;
};
StripRoom strip_room(int dimension, const Font& font);

/// Draws how many objects are open at each place of an axis: those that a box which begins there is tested
/// against. Heights are logarithmic, up to all objects, so that their scale does not jump. `scene`: of the
/// pane, without the strips.
template <int D>
void draw_axis_strips(const View& view, const Font& font, const Viewport& scene, const Box<D>& bounds,
                      std::span<const AxisList> lists, std::span<const Body<D>> bodies, Overlay& overlay);

}  // namespace kerf
