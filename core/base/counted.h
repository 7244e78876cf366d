#pragma once

#include <cstdint>
#include <string>

namespace kerf {

/// "1 box", "2 boxes": a number and what it counts.
inline std::string counted(std::uint64_t number, const std::string& one, const std::string& many) {
  return std::to_string(number) + " " + (number == 1 ? one : many);
}

/// The same for words whose plural ends with an s: "1 step", "0 steps".
inline std::string counted(std::uint64_t number, const std::string& one) {
  return counted(number, one, one + "s");
}

/// "1 of 25 frames is", "3 of 25 frames are".
inline std::string counted_of(std::uint64_t number, std::uint64_t all, const std::string& one) {
  return std::to_string(number) + " of " + counted(all, one) + (number == 1 ? " is" : " are");
}

}  // namespace kerf
