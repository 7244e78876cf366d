#include "core/base/rgb.h"

#include <array>
#include <charconv>

namespace kerf {

std::optional<Rgb> parse_rgb(std::string_view text) {
  constexpr std::size_t kShort = 3;  // digits
  constexpr std::size_t kLong = 6;
  constexpr int kSixteen = 16;
  if (text.starts_with('#')) text.remove_prefix(1);
  if (text.size() != kShort && text.size() != kLong) return std::nullopt;
  const std::size_t width = text.size() / 3;
  std::array<std::uint8_t, 3> parts{};
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const std::string_view digits = text.substr(k * width, width);
    const auto [stop, error] = std::from_chars(digits.data(), digits.data() + width, parts[k], kSixteen);
    if (error != std::errc{} || stop != digits.data() + width) return std::nullopt;
    if (width == 1) parts[k] = static_cast<std::uint8_t>(parts[k] * (kSixteen + 1));
  }
  return Rgb{parts[0], parts[1], parts[2]};
}

std::string to_string(const Rgb& color) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  constexpr unsigned kSixteen = 16;
  std::string text = "#";
  for (const unsigned part : {color.r, color.g, color.b}) {
    text += kDigits[part / kSixteen];
    text += kDigits[part % kSixteen];
  }
  return text;
}

}  // namespace kerf
