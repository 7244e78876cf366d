#include "frames/import/written_digits.h"

#include <algorithm>
#include <charconv>
#include <cstdint>

namespace kerf {
namespace {

bool is_digit_character(char c) { return c >= '0' && c <= '9'; }

/// Behind the e; 0 if there is none.
int exponent_of(std::string_view text) {
  if (text.empty() || (text.front() != 'e' && text.front() != 'E')) return 0;
  text.remove_prefix(1);
  if (text.starts_with('+')) text.remove_prefix(1);
  int exponent = 0;
  std::from_chars(text.data(), text.data() + text.size(), exponent);
  return exponent;
}

}  // namespace

void note_digits(std::string_view text, WrittenDigits& written) {
  std::int64_t significant = 0;
  std::int64_t decimals = 0;
  bool has_digit = false;
  bool has_point = false;
  char last = '0';
  text.remove_prefix(std::min(text.find_first_not_of("+-"), text.size()));
  for (; !text.empty() && (text.front() == '.' || is_digit_character(text.front())); text.remove_prefix(1)) {
    if (text.front() == '.') {
      has_point = true;
      continue;
    }
    has_digit = true;
    last = text.front();
    significant += significant > 0 || text.front() != '0' ? 1 : 0;
    decimals += has_point ? 1 : 0;
  }
  if (!has_digit) return;
  decimals = std::max<std::int64_t>(decimals - exponent_of(text), 0);
  if (decimals == 1 && (last == '0' || last == '5')) decimals = 0;
  written.significant =
      std::max(written.significant, static_cast<std::uint32_t>(std::max<std::int64_t>(significant, 1)));
  written.decimals = std::max(written.decimals, static_cast<std::uint32_t>(decimals));
}

}  // namespace kerf
