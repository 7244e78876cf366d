#pragma once

#include "viz/draw/overlay.h"

namespace kerf {

/// From the lower edge of the part to the highest letter, in lengths.
inline constexpr double kTriadHeight = 3.4;

/// Draws the directions of the axes of the scene, with their names, at the lower left or the lower right of a
/// part of the picture. `length`: in pixels, of an axis that lies across the view.
enum class Corner { left, right };
void draw_triad(const View& view, const Font& font, const Viewport& part, Corner corner, double length,
                Overlay& overlay);

}  // namespace kerf
