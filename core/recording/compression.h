#pragma once

#include <span>

#include "core/recording/bytes.h"

namespace kerf {

/// Zstandard frames with a checksum.
Bytes compress(std::span<const std::uint8_t> bytes);
/// Throws std::runtime_error if the bytes are no such frame or were changed.
Bytes decompress(std::span<const std::uint8_t> frame);

}  // namespace kerf
