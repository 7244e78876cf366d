#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "core/files/part_file.h"
#include "viz/image/image.h"

namespace kerf {

/// Largest side of an image that is read or written, in pixels.
inline constexpr int kMaxImageSide = 16384;

/// Writes a PNG, without an alpha channel if the image is opaque. The file appears under its name only when
/// it is complete (PartFile). Throws std::runtime_error with the path and the reason; nothing is left behind
/// then.
void write_png(const std::filesystem::path& path, const Image& image, Replace replace = Replace::earlier,
               Sync sync = Sync::now);

/// The bytes of that file.
std::vector<std::uint8_t> encode_png(const Image& image);

/// Reads a PNG that has nothing but pixels of 8 bits. Throws std::runtime_error as `read_stored_picture`
/// does, and for one with more: 16 bits a channel, colour profiles, animations.
Image read_png(const std::filesystem::path& path);
/// The same for a PNG in memory; errors call it `path`.
Image read_png(std::span<const std::uint8_t> bytes, const std::filesystem::path& path);

/// Hash of the size and the decoded pixels: equal for equal pictures, whatever their compression.
std::uint64_t pixel_hash(const Image& image);

}  // namespace kerf
