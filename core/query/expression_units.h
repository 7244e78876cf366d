#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "core/query/expression.h"

namespace kerf {

/// What part of an expression measures, and so which units a number that is compared with it may have.
struct ExpressionMeasure {
  enum class Quantity : std::uint8_t {
    bare,   ///< a number without a unit: it may be any of the others
    plain,  ///< a count or another number that no unit fits
    share,  ///< %
    time,   ///< s, ms, us
  };
  Quantity quantity = Quantity::bare;
  /// Where in the text the unit, or the bare `median`, stands that makes the quantity; none if another word
  /// makes it.
  std::optional<std::size_t> unit_place;
  bool is_of_median = false;  ///< a bare `median` stands there
};

/// A word's measure, also that of its median.
ExpressionMeasure measure_of(Variable variable);

/// Of two numbers joined by `kind`, which is an operator with two operands. The quotient of two counts or of
/// two times is a share; a share of a quantity is such a quantity.
ExpressionMeasure joined(ExpressionPart::Kind kind, const ExpressionMeasure& left,
                         const ExpressionMeasure& right);

/// Whether `kind` (a comparison, a sum or a difference) joins a unit that was written, or a bare `median`,
/// with a quantity that does not have it; or a quotient is one of another quantity and a bare `median`. Other
/// words of different quantities may be joined: a number of the user's may scale one.
bool is_misfit(ExpressionPart::Kind kind, const ExpressionMeasure& left, const ExpressionMeasure& right);

/// "has no unit", "takes s, ms and us only"
std::string_view units_text(ExpressionMeasure::Quantity quantity);

}  // namespace kerf
