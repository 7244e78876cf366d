#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "viz/image/image.h"
#include "viz/image/png_chunks.h"

namespace kerf {

/// Everything in a PNG file that decides how it looks: a comparison must compare all of it.
struct StoredPicture {
  Image image;  ///< where channels have 16 bits, the upper 8 of each
  /// The lower 8 bits, laid out as `image.rgba`. Empty: channels have 8 bits, which stand for both halves.
  std::vector<std::uint8_t> lower;
  std::vector<PngChunk> chunks;  ///< beside the pixels, see `walk_png_chunks`
};

/// Reads a PNG of any kind: palettes, interlacing, transparency, 1 to 16 bits. Throws std::runtime_error with
/// the path and the reason (missing, not a PNG, truncated, damaged, larger than kMaxImageSide); memory is
/// taken only after the size is known to be sane.
StoredPicture read_stored_picture(const std::filesystem::path& path);
/// The same for a PNG in memory; errors call it `path`.
StoredPicture read_stored_picture(std::span<const std::uint8_t> bytes, const std::filesystem::path& path);

/// Pixels of which the upper halves are the same and the lower ones are not.
///
/// Pre: both have the same size.
std::uint64_t count_different_lower(const StoredPicture& a, const StoredPicture& b);

/// The types of chunks that are not the same in both, as "gAMA, iCCP"; empty if all are.
std::string different_chunks(const StoredPicture& a, const StoredPicture& b);

}  // namespace kerf
