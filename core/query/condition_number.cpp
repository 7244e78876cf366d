#include "core/query/condition_number.h"

#include <array>
#include <charconv>

namespace kerf {

std::string to_text(const ConditionNumber& number) {
  constexpr long double kMost = 0x1p64L;  // ids have 64 bits
  const bool is_whole =
      number.exact && std::abs(*number.exact) < kMost && std::trunc(*number.exact) == *number.exact;
  if (!is_whole) return number_text(number.nearest);
  std::array<char, 40> text{};
  return {
      text.data(),
      std::to_chars(text.data(), text.data() + text.size(), *number.exact, std::chars_format::fixed, 0).ptr};
}

}  // namespace kerf
