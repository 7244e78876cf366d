#pragma once

#include <string>

#include "core/query/expression.h"

namespace kerf {

/// Throws UsageError that begins with the option's name and shows the error and its place.
Expression parse_expression(const std::string& option, const std::string& text);

}  // namespace kerf
