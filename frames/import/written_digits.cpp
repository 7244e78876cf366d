#include "frames/import/written_digits.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

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

/// Digits before the exponent, and the exponent, of the shortest text of a number.
struct Decimal {
  int digits = 0;
  int exponent = 0;
};
Decimal decimal_of(double x) {
  std::array<char, 64> room{};
  const char* const end = std::to_chars(room.begin(), room.end(), x, std::chars_format::scientific).ptr;
  const std::string_view text(room.data(), end);
  const std::size_t e = std::min(text.find('e'), text.size());
  const auto digits = std::ranges::count_if(text.substr(0, e), is_digit_character);
  return {static_cast<int>(digits), exponent_of(text.substr(e))};
}

bool is_a_float(double x) { return static_cast<double>(static_cast<float>(x)) == x; }

/// How far apart the written bounds may be from how far apart the engine's were.
double rounding_of(double x, double y) {
  if (!std::isfinite(x) || !std::isfinite(y) || (is_a_float(x) && is_a_float(y))) return 0;
  const Decimal first = decimal_of(x);
  const Decimal second = decimal_of(y);
  const int digits = std::max(first.digits, second.digits);
  if (digits < 4 || digits > 8) return 0;
  const auto half_unit = [digits](const Decimal& of) {
    return 0.5 * std::pow(10.0, of.exponent - digits + 1);
  };
  return half_unit(first) + half_unit(second);
}

}  // namespace

template <int D>
bool hangs_on_digits(const GivenBox<D>& a, const GivenBox<D>& b) {
  double apart = -std::numeric_limits<double>::infinity();
  double rounding = 0;
  for (std::size_t i = 0; i < D; ++i)
    for (const auto& [min, max] : {std::pair(a.min[i], b.max[i]), std::pair(b.min[i], a.max[i])}) {
      if (!(min - max > apart)) continue;
      apart = min - max;
      rounding = rounding_of(min, max);
    }
  constexpr double kOfDoubles = 1 + 1e-9;  // both are rounded themselves
  return rounding > 0 && std::abs(apart) <= kOfDoubles * rounding;
}

template bool hangs_on_digits<2>(const GivenBox<2>&, const GivenBox<2>&);
template bool hangs_on_digits<3>(const GivenBox<3>&, const GivenBox<3>&);

void note_digits(std::string_view text, WrittenDigits& written) {
  std::int64_t significant = 0;
  std::int64_t decimals = 0;
  bool has_digit = false;
  bool has_point = false;
  text.remove_prefix(std::min(text.find_first_not_of("+-"), text.size()));
  for (; !text.empty() && (text.front() == '.' || is_digit_character(text.front())); text.remove_prefix(1)) {
    if (text.front() == '.') {
      has_point = true;
      continue;
    }
    has_digit = true;
    significant += significant > 0 || text.front() != '0' ? 1 : 0;
    decimals += has_point ? 1 : 0;
  }
  if (!has_digit) return;
  decimals = std::max<std::int64_t>(decimals - exponent_of(text), 0);
  written.significant =
      std::max(written.significant, static_cast<std::uint32_t>(std::max<std::int64_t>(significant, 1)));
  written.decimals = std::max(written.decimals, static_cast<std::uint32_t>(decimals));
}

}  // namespace kerf
