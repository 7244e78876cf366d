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
  friend bool operator==(const PngChunk&, const PngChunk&) = default;
};

/// Walks the chunks: they must be whole, undamaged, begin with a header that can be true, and end with IEND
/// and the file. Returns those that the decoder of the pixels does not look at and that are no remarks, in
/// their order: what says how pixels are shown (gAMA, iCCP, eXIf), further frames of an animation, and all
/// that is unknown. Throws std::runtime_error with the path and the reason.
std::vector<PngChunk> walk_png_chunks(std::span<const std::uint8_t> bytes, const std::filesystem::path& path);

/// Throws the std::runtime_error that says why a picture cannot be read.
[[noreturn]] void fail_to_read_png(const std::filesystem::path& path, const std::string& reason);

}  // namespace kerf
