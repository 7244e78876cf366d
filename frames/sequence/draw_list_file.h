#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "viz/draw/draw_list.h"

namespace kerf {

/// The files beside a frame that was drawn with ids.
struct StoredIds {
  FrameIds ids;
  std::string rasterizer;  ///< that drew the frame
};

/// Writes `frame`.ids.png and `frame`.draw.json, to be brought to the disk with the frame. Throws
/// std::runtime_error with path and reason.
void write_ids(const std::filesystem::path& frame, const StoredIds& stored);

/// None if there is neither file. Throws std::runtime_error if one is missing or cannot be read.
std::optional<StoredIds> read_ids(const std::filesystem::path& frame);

}  // namespace kerf
