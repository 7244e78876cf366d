#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace kerf {

/// A colour as people write it, each part from 0 to 255.
struct Rgb {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;
  friend constexpr bool operator==(const Rgb&, const Rgb&) = default;
};

/// Reads "#1f77b4", "1f77b4" and "#17b", in capitals, too; nothing for anything else.
std::optional<Rgb> parse_rgb(std::string_view text);
/// "#1f77b4"
std::string to_string(const Rgb& color);

}  // namespace kerf
