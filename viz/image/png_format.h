#pragma once

#include <array>
#include <cstdint>

/// The common part of the reader and the writer of PNG files (W3C PNG, 3rd edition).
namespace kerf::png {

inline constexpr std::array<std::uint8_t, 8> kSignature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
/// Colour types of the header.
inline constexpr std::uint8_t kRgb = 2;
inline constexpr std::uint8_t kRgba = 6;

}  // namespace kerf::png
