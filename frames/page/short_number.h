#pragma once

#include <array>
#include <cmath>
#include <cstdio>
#include <string>

namespace kerf {

/// A number for people: three digits that count, as few characters as that takes, or all of a whole one.
inline std::string short_number(double x) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), std::abs(x) >= 100 ? "%.0f" : "%.3g", x);
  return text.data();
}

}  // namespace kerf
