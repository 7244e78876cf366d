#pragma once

#include <span>

#include "core/base/bytes.h"

namespace kerf {

/// Zstandard frames with a checksum, of at least `least` bytes. Data that compresses to less, or better than
/// a reader accepts, is followed by a frame that readers skip: so a file of a few bytes cannot request
/// gigabytes.
Bytes compress(std::span<const std::uint8_t> bytes, std::size_t least = 0);
/// Throws std::runtime_error if the bytes are no such frames or were changed.
Bytes decompress(std::span<const std::uint8_t> frames);

}  // namespace kerf
