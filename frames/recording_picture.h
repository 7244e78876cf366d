#pragma once

#include <filesystem>

#include "core/replay/cursor.h"
#include "frames/picture_size.h"

namespace kerf {

/// Draws the moment at which a cursor stands, the boxes as boxes, and writes it as PNG. Throws
/// std::runtime_error if it cannot be drawn or written.
template <int D>
void draw_moment(Cursor<D>& cursor, const PictureSize& size, const std::filesystem::path& path);

}  // namespace kerf
