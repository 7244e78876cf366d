#pragma once

#include <filesystem>

#include "core/files/part_file.h"
#include "core/replay/cursor.h"
#include "frames/support/picture_size.h"
#include "viz/draw/frame_renderer.h"

namespace kerf {

/// The layers of a recording: all but contacts, because it has no narrow phase.
inline constexpr LayerSet kRecordedLayers = LayerSet::all().with(Layer::contacts, false);

/// The picture of a cursor's moment, with boxes for objects. Throws std::runtime_error if drawing fails. It
/// is valid until the renderer's next one.
template <int D>
const Image& render_moment(Cursor<D>& cursor, FrameRenderer<D>& renderer);

/// Writes that picture as PNG. Throws std::runtime_error if it cannot be drawn or written.
template <int D>
void draw_moment(Cursor<D>& cursor, const PictureSize& size, const std::filesystem::path& path,
                 Replace replace);

}  // namespace kerf
