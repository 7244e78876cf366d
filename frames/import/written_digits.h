#pragma once

#include <string_view>

#include "core/recording/their_digits.h"

namespace kerf {

/// Notes with how many digits a number was written: 1.50e-3 has 3, and 5 decimals. A single decimal 0 or 5
/// does not count. What is no number, nan or inf has none.
void note_digits(std::string_view text, WrittenDigits& written);

}  // namespace kerf
