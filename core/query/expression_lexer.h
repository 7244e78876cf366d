#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "core/query/expression_units.h"

namespace kerf {

/// A piece of an expression's text.
struct Token {
  enum class Kind : std::uint8_t { number, word, symbol, end };
  Kind kind = Kind::end;
  std::string_view text{};      ///< for a number its digits and its unit
  ConditionNumber number{};     ///< in seconds where a unit of time was given
  std::size_t place = 0;        ///< where it begins
  ExpressionMeasure measure{};  ///< of a number
};

/// Cuts an expression into tokens, the last being `end`. A hyphen is a minus, but in the name of a value
/// (`shift-split`). Throws std::invalid_argument for characters that belong to no token.
std::vector<Token> tokens_of(std::string_view text);

/// Throws std::invalid_argument with the text, a mark below the place, and the error.
[[noreturn]] void reject_expression(std::string_view text, std::size_t place, std::string_view what);

}  // namespace kerf
