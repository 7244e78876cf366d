#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace kerf {

/// A chunk of a PNG file.
struct PngChunk {
  std::string type;
  std::vector<std::uint8_t> data;
  bool after_pixels = false;  ///< where some programs heed it and others do not
  friend bool operator==(const PngChunk&, const PngChunk&) = default;
};

/// Walks the chunks: they must be whole, undamaged, begin with a header that can be true, and end with IEND
/// and the file. Returns, in their order, the chunks that the decoder of the pixels ignores and that are
/// no comments: those that decide how pixels are shown (gAMA, iCCP, eXIf), further frames of an
/// animation, and unknown ones. Throws std::runtime_error with the path and the reason.
std::vector<PngChunk> walk_png_chunks(std::span<const std::uint8_t> bytes, const std::filesystem::path& path);

/// Throws the std::runtime_error that says why a picture cannot be read.
[[noreturn]] void fail_to_read_png(const std::filesystem::path& path, const std::string& reason);

}  // namespace kerf
