#pragma once

#include <string>
#include <string_view>

#include "frames/support/errors.h"
#include "frames/support/parse_number.h"

namespace kerf {

/// The number for an option. Throws UsageError that names the option and the allowed values.
template <class Number>
Number parse_whole(std::string_view option, std::string_view text, Number least, Number most) {
  const auto number = parse_number<Number>(text);
  if (!number || *number < least || *number > most)
    throw UsageError(std::string(option) + " '" + std::string(text) + "' is not a whole number from " +
                     std::to_string(least) + " to " + std::to_string(most));
  return *number;
}

}  // namespace kerf
