#pragma once

#include "core/query/expression.h"

namespace kerf {

/// A moment of a run, as an expression asks about it.
class Moment {
 public:
  Moment() = default;
  Moment(const Moment&) = delete;
  Moment& operator=(const Moment&) = delete;
  virtual ~Moment() = default;

  /// NaN for what does not exist at this moment, such as the node of an event that has none.
  [[nodiscard]] virtual double number(Variable variable) const = 0;
  [[nodiscard]] virtual double median(Variable variable) const = 0;
  [[nodiscard]] virtual bool happens(const ExpressionPart& happening) const = 0;
};

/// Whether the expression holds. A comparison with what does not exist is false, whichever it is.
bool holds(const Expression& expression, const Moment& moment);
/// The number that an expression stands for, 1 or 0 for a condition; NaN for what does not exist.
double value(const Expression& expression, const Moment& moment);

}  // namespace kerf
