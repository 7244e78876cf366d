#pragma once

#include <span>
#include <string_view>

#include "core/query/expression.h"

namespace kerf {

/// A word of the language of conditions that stands for a number of a step or event.
struct VariableWord {
  Variable variable;
  std::string_view name;
  std::string_view meaning;
};
std::span<const VariableWord> variable_words();

/// A word that is a value of `op`, `kind` or `phase` and of nothing else.
struct NamedValue {
  Variable of;
  std::string_view name;
  double value;
};
std::span<const NamedValue> named_values();

}  // namespace kerf
