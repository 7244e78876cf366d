#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace kerf {

/// Another program's name of an object: any whole number that 64 bits hold, with a sign or without one.
struct GivenId {
  bool negative = false;
  std::uint64_t magnitude = 0;

  static constexpr GivenId of(std::uint32_t number) { return {false, number}; }
  friend constexpr bool operator==(const GivenId&, const GivenId&) = default;
  friend constexpr std::strong_ordering operator<=>(const GivenId& a, const GivenId& b) {
    if (a.negative != b.negative)
      return a.negative ? std::strong_ordering::less : std::strong_ordering::greater;
    return a.negative ? b.magnitude <=> a.magnitude : a.magnitude <=> b.magnitude;
  }
};

/// Reads "17", "+17", "-12034" and "17.0"; nothing for anything else, nor for what 64 bits do not hold.
std::optional<GivenId> parse_given_id(std::string_view text);
/// Without a plus sign and leading zeros.
std::string to_string(const GivenId& id);

}  // namespace kerf
