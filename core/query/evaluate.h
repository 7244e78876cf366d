#pragma once

#include "core/query/expression.h"

namespace kerf {

/// A moment of a run, as expressions see it.
class Moment {
 public:
  Moment() = default;
  Moment(const Moment&) = delete;
  Moment& operator=(const Moment&) = delete;
  virtual ~Moment() = default;

  /// NaN for a value that does not exist at this moment, such as the node of an event without one.
  [[nodiscard]] virtual double number(Variable variable) const = 0;
  [[nodiscard]] virtual double median(Variable variable) const = 0;
  [[nodiscard]] virtual bool happens(const ExpressionPart& happening) const = 0;
};

/// Whether the expression holds. A comparison with a value that does not exist is false.
bool holds(const Expression& expression, const Moment& moment);
/// The value of an expression, 1 or 0 for a condition; NaN if it does not exist.
double value(const Expression& expression, const Moment& moment);

}  // namespace kerf
