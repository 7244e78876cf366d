#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace kerf {

/// How the numbers of a table were written: the most digits that any of them has.
struct WrittenDigits {
  std::uint32_t significant = 0;  ///< without leading zeros; 0: it is not known
  std::uint32_t decimals = 0;  ///< behind the point, less the exponent; none of a .0 or .5, which are exact
  bool coarse = false;         ///< all were rounded or cut to so few, as the other table shows
  friend bool operator==(const WrittenDigits&, const WrittenDigits&) = default;
};

/// How an import's boxes and the nodes of another engine's structure were written.
struct TheirDigits {
  WrittenDigits boxes;
  WrittenDigits nodes;
  friend bool operator==(const TheirDigits&, const TheirDigits&) = default;
};

/// A unit of the last place that a finite number of the table has.
inline double last_place(const WrittenDigits& written, double number) {
  const double of_decimals = std::pow(10.0, -static_cast<double>(written.decimals));
  if (number == 0) return of_decimals;
  const double before_point = std::floor(std::log10(std::abs(number))) + 1;
  return std::max(std::pow(10.0, before_point - static_cast<double>(written.significant)), of_decimals);
}

/// What writing may have rounded away of a number: programs write at least six digits (%g), or so many
/// decimals (%f). Of fewer, where it is known that they are no numbers by intent, the digits behind the last
/// place may have been cut off. 0 if it is not known how they wrote.
inline double rounded_away(const WrittenDigits& written, double number) {
  constexpr std::uint32_t kLeastDigits = 6;
  if (written.significant == 0 || !std::isfinite(number)) return 0;
  if (written.coarse) return last_place(written, number);
  const double of_decimals =
      written.decimals == 0 ? 0 : 0.5 * std::pow(10.0, -static_cast<double>(written.decimals));
  if (number == 0) return of_decimals;
  const double before_point = std::floor(std::log10(std::abs(number))) + 1;
  const auto digits = static_cast<double>(std::max(written.significant, kLeastDigits));
  return std::max(0.5 * std::pow(10.0, before_point - digits), of_decimals);
}

}  // namespace kerf
