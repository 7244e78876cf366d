#pragma once

#include <charconv>
#include <optional>
#include <string_view>

namespace kerf {

/// The whole of `text` as a number without sign or spaces; nothing if it is not one or does not fit.
template <class Number>
std::optional<Number> parse_number(std::string_view text) {
  Number number{};
  const char* const end = text.data() + text.size();
  if (text.empty() || text[0] == '-') return std::nullopt;
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return number;
}

}  // namespace kerf
