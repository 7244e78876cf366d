#pragma once

#include <optional>
#include <string_view>

#include "core/base/number_text.h"

namespace kerf {

/// The whole of `text` as a number without sign or spaces; nothing if it is not one or does not fit.
template <class Number>
std::optional<Number> parse_number(std::string_view text) {
  return text.starts_with('-') ? std::nullopt : read_number<Number>(text);
}

}  // namespace kerf
