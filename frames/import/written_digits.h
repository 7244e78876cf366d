#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "core/recording/their_digits.h"

namespace kerf {

/// What the text of a number shows.
struct NumberDigits {
  std::int64_t significant = 0;  ///< without leading zeros, but at least 1
  std::int64_t decimals = 0;     ///< behind the point, less the exponent
  bool has_point = false;
  char last = '0';  ///< of the digits, before an exponent
};
/// None if the text has no digit.
std::optional<NumberDigits> read_digits(std::string_view text);

/// Notes with how many digits a number was written: 1.50e-3 has 3, and 5 decimals. A single decimal 0 or 5
/// does not count. What is no number, nan or inf has none.
void note_digits(std::string_view text, WrittenDigits& written);

/// Whether a text of more than 15 digits may have been written of the double that it is read as: the double's
/// own digits as far as the text goes, whether rounded there or cut, then zeros. Others, such as
/// 9007199254740993 and 1.000000000000000001, are numbers between doubles. Shorter texts are what they are.
bool may_be_of_double(std::string_view text, double number);

}  // namespace kerf
