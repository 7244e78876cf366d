#pragma once

#include "viz/draw/clip.h"
#include "viz/draw/draw_context.h"
#include "viz/draw/strokes.h"

namespace kerf {

/// The edges of a box.
template <int D>
void outline_box(const DrawContext<D>& frame, const Box<D>& box, const Stroke& stroke, Batch& batch) {
  const auto sides = half_spaces(box);
  for (const HalfSpace& side : sides) add_outline(batch, frame.view, plane_within(side, box, sides), stroke);
}

}  // namespace kerf
