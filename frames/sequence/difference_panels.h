#pragma once

#include "viz/image/image.h"

namespace kerf {

/// Both pictures side by side, and right of them the first one pale, with the differences in red. `differing`
/// is the number of pixels that differ. Each panel is shrunk to at most `panel_width`. Throws
/// std::invalid_argument if their sizes differ.
Image difference_panels(const Image& a, const Image& b, int panel_width, std::size_t& differing);

}  // namespace kerf
