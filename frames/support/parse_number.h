#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/number_text.h"
#include "frames/support/errors.h"

namespace kerf {

/// The whole of `text` as a number without sign or spaces; nothing if it is not one or does not fit.
template <class Number>
std::optional<Number> parse_number(std::string_view text) {
  return text.starts_with('-') ? std::nullopt : read_number<Number>(text);
}

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
