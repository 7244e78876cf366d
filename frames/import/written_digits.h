#pragma once

#include <string_view>

#include "core/geometry/given_box.h"
#include "core/recording/their_digits.h"

namespace kerf {

/// Notes with how many digits a number was written: 1.50e-3 has 3, and 5 decimals. What is no number, nan or
/// inf has none.
void note_digits(std::string_view text, WrittenDigits& written);

/// Whether two boxes overlap, or not, by less than the rounding of bounds that were written with 4 to 8
/// digits: then the engine's own boxes may have done otherwise. Fewer digits are taken for a number's own,
/// and so is what a float is exactly.
template <int D>
bool hangs_on_digits(const GivenBox<D>& a, const GivenBox<D>& b);

}  // namespace kerf
