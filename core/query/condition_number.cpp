#include "core/query/condition_number.h"

#include <array>
#include <charconv>

namespace kerf {

std::string to_text(const ConditionNumber& number) {
  const std::optional<long double> whole = number.whole();
  if (!whole) return number_text(number.nearest);
  std::array<char, 40> text{};
  return {text.data(),
          std::to_chars(text.data(), text.data() + text.size(), *whole, std::chars_format::fixed, 0).ptr};
}

}  // namespace kerf
