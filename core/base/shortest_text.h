#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <string>

namespace kerf {

/// The shortest text that reads back as the same number, so that two numbers that differ look different; with
/// an exponent only where there would be many zeros.
template <class Number>
std::string shortest_text(Number x) {
  constexpr Number kLeast = static_cast<Number>(1e-4);
  constexpr Number kMost = static_cast<Number>(1e15);
  const Number size = std::abs(x);
  const bool is_plain = size == 0 || (size >= kLeast && size < kMost);
  std::array<char, 40> text{};
  const auto format = is_plain ? std::chars_format::fixed : std::chars_format::general;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), x, format).ptr};
}

}  // namespace kerf
