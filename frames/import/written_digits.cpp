#include "frames/import/written_digits.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <string>

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

/// Of a number without its exponent, from the first digit that is not 0 to the last one.
std::string digits_in(std::string_view text) {
  std::string digits;
  for (const char c : text.substr(0, text.find_first_of("eE")))
    if (is_digit_character(c) && (c != '0' || !digits.empty())) digits += c;
  digits.erase(digits.find_last_not_of('0') + 1);
  return digits;
}

std::string digits_of(double number, std::size_t count) {
  std::array<char, 800> text{};
  const auto end = std::to_chars(text.begin(), text.end(), number, std::chars_format::scientific,
                                 static_cast<int>(count) - 1);
  return digits_in({text.begin(), end.ptr});
}

/// One more in the last place.
std::string next_up(std::string digits) {
  const std::size_t last = digits.find_last_not_of('9');
  if (last == std::string::npos) return "1";
  digits.erase(last + 1);
  ++digits[last];
  return digits;
}

}  // namespace

bool may_be_of_double(std::string_view text, double number) {
  constexpr std::size_t kAlwaysWhole = 15;
  constexpr std::size_t kMostDigits = 767;  // that a double has
  const std::string given = digits_in(text);
  if (given.size() <= kAlwaysWhole) return true;
  if (given.size() > kMostDigits) return false;
  if (digits_of(number, given.size()) == given) return true;
  const std::string all = digits_of(number, kMostDigits);
  const std::string cut = all.substr(0, given.size());
  return given == cut || (all.size() > given.size() && all[given.size()] >= '5' && given == next_up(cut));
}

std::optional<NumberDigits> read_digits(std::string_view text) {
  NumberDigits number;
  bool has_digit = false;
  text.remove_prefix(std::min(text.find_first_not_of("+-"), text.size()));
  for (; !text.empty() && (text.front() == '.' || is_digit_character(text.front())); text.remove_prefix(1)) {
    if (text.front() == '.') {
      number.has_point = true;
      continue;
    }
    has_digit = true;
    number.last = text.front();
    number.significant += number.significant > 0 || text.front() != '0' ? 1 : 0;
    number.decimals += number.has_point ? 1 : 0;
  }
  if (!has_digit) return std::nullopt;
  number.decimals -= exponent_of(text);
  number.significant = std::max<std::int64_t>(number.significant, 1);
  return number;
}

void note_digits(std::string_view text, WrittenDigits& written) {
  const auto number = read_digits(text);
  if (!number) return;
  std::int64_t decimals = std::max<std::int64_t>(number->decimals, 0);
  if (decimals == 1 && (number->last == '0' || number->last == '5')) decimals = 0;
  written.significant = std::max(written.significant, static_cast<std::uint32_t>(number->significant));
  written.decimals = std::max(written.decimals, static_cast<std::uint32_t>(decimals));
}

}  // namespace kerf
