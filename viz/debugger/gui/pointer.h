#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace kerf {

/// The shape of the mouse pointer over what it can do.
enum class Pointer : std::uint8_t { arrow, text, across, down, hand };
inline constexpr std::array<std::string_view, 5> kPointerNames{"arrow", "text", "across", "down", "hand"};

}  // namespace kerf
