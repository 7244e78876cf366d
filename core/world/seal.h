#pragma once

#include <cstdint>
#include <span>

namespace kerf {

/// A checksum (XXH3, 64 bits): finds bytes that were changed by accident, not those that were forged.
std::uint64_t seal_of(std::span<const std::uint8_t> bytes);

}  // namespace kerf
