#pragma once

#include <filesystem>

namespace kerf {

/// "a.png" -> "a.ids.png": which item of the draw list covers each pixel.
inline std::filesystem::path ids_path(const std::filesystem::path& frame) {
  return std::filesystem::path(frame).replace_extension(".ids.png");
}

/// "a.png" -> "a.draw.json": what was drawn.
inline std::filesystem::path draw_list_path(const std::filesystem::path& frame) {
  return std::filesystem::path(frame).replace_extension(".draw.json");
}

}  // namespace kerf
