#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace kerf {

/// Base64 (RFC 4648) of bytes, for pictures in pages.
inline std::string base64(std::span<const std::uint8_t> bytes) {
  constexpr const char* kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t k) { return i + k < bytes.size() ? std::uint32_t{bytes[i + k]} : 0U; };
    const std::uint32_t group = byte(0) << 16U | byte(1) << 8U | byte(2);
    for (std::uint32_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? kLetters[group >> (18U - 6U * k) & 63U] : '=';
  }
  return text;
}

}  // namespace kerf
