#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace kerf {

/// The middle of some samples, and what they spread over: from the least to the greatest, without the tenth
/// of them (rounded down) at either end.
struct Spread {
  double median = 0;
  double low = 0;
  double high = 0;
  std::size_t samples = 0;
};

/// None if there are no samples, or if one of them is NaN: no figure.
std::optional<Spread> spread_of(std::vector<double> samples);

/// "0.31 (0.29 to 0.35)"; without the spread if there is one sample, or none to be seen in three digits.
std::string text_of(const Spread& spread);

}  // namespace kerf
