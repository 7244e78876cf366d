#pragma once

#include "core/query/condition_number.h"
#include "core/query/expression.h"

namespace kerf {

/// A moment of a run, as expressions see it.
class Moment {
 public:
  Moment() = default;
  Moment(const Moment&) = delete;
  Moment& operator=(const Moment&) = delete;
  virtual ~Moment() = default;

  /// None of a value that does not exist at this moment, such as the node of an event without one.
  [[nodiscard]] virtual ConditionNumber number(Variable variable) const = 0;
  [[nodiscard]] virtual ConditionNumber median(Variable variable) const = 0;
  [[nodiscard]] virtual bool happens(const ExpressionPart& happening) const = 0;
};

/// Whether the expression holds. A comparison with a value that does not exist is false.
bool holds(const Expression& expression, const Moment& moment);
/// The value of an expression, 1 or 0 for a condition; one that may not exist.
ConditionNumber value(const Expression& expression, const Moment& moment);

}  // namespace kerf
