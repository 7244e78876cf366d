#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <string>

namespace kerf {

/// A hash as 16 hexadecimal digits.
inline std::string hex(std::uint64_t hash) {
  std::array<char, 17> text{};
  std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(hash));
  return text.data();
}

}  // namespace kerf
