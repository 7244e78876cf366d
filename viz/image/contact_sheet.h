#pragma once

#include <span>

#include "viz/image/image.h"

namespace kerf {

/// Shrinks by averaging all pixels that fall into each target pixel. Throws std::invalid_argument if the
/// target is empty or larger than the source.
Image downscale(const Image& image, int width, int height);

/// Puts pictures of one size into a grid, row by row, with a margin between them.
/// Throws std::invalid_argument if there is none, their sizes differ, or `columns` is below 1.
Image contact_sheet(std::span<const Image> thumbs, int columns);

}  // namespace kerf
