#pragma once

#include <array>
#include <cstdio>
#include <string>

namespace kerf {

/// As printf prints it: up to 399 bytes.
template <class... Values>
std::string printed(const char* pattern, Values... values) {
  std::array<char, 400> text{};
  std::snprintf(text.data(), text.size(), pattern, values...);
  return text.data();
}

}  // namespace kerf
