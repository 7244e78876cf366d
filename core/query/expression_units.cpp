#include "core/query/expression_units.h"

namespace kerf {
namespace {

using Kind = ExpressionPart::Kind;
using Quantity = ExpressionMeasure::Quantity;

/// The unit was written only if that of both was, or the other may be anything.
ExpressionMeasure sum(const ExpressionMeasure& left, const ExpressionMeasure& right) {
  if (left.quantity == Quantity::bare) return right;
  if (right.quantity == Quantity::bare) return left;
  if (left.quantity != right.quantity) return {};
  return left.unit_place && right.unit_place ? left : ExpressionMeasure{left.quantity, {}};
}

ExpressionMeasure product(const ExpressionMeasure& left, const ExpressionMeasure& right) {
  if (left.quantity == Quantity::bare) return right;
  if (right.quantity == Quantity::bare) return left;
  if (left.quantity == Quantity::share) return right;
  if (right.quantity == Quantity::share) return left;
  if (left.quantity == Quantity::time && right.quantity == Quantity::time) return {Quantity::plain, {}};
  return left.quantity == Quantity::time ? left : right;
}

ExpressionMeasure quotient(const ExpressionMeasure& left, const ExpressionMeasure& right) {
  if (right.quantity == Quantity::bare || right.quantity == Quantity::share) return left;
  if (left.quantity == right.quantity) return {Quantity::share, {}};
  if (right.quantity == Quantity::time) return {Quantity::plain, {}};
  return left;
}

}  // namespace

ExpressionMeasure measure_of(Variable variable) {
  if (variable >= Variable::step_time && variable <= Variable::sweep_time) return {Quantity::time, {}};
  if (variable == Variable::redundancy || variable == Variable::balance) return {Quantity::share, {}};
  return {Quantity::plain, {}};
}

ExpressionMeasure joined(Kind kind, const ExpressionMeasure& left, const ExpressionMeasure& right) {
  switch (kind) {
    case Kind::multiply:
      return product(left, right);
    case Kind::divide:
      return quotient(left, right);
    case Kind::add:
    case Kind::subtract:
      return sum(left, right);
    default:
      return {Quantity::plain, {}};
  }
}

bool is_misfit(Kind kind, const ExpressionMeasure& left, const ExpressionMeasure& right) {
  if (kind == Kind::multiply || kind >= Kind::both || left.quantity == right.quantity) return false;
  if (left.quantity == Quantity::bare || right.quantity == Quantity::bare) return false;
  if (kind == Kind::divide) return right.is_of_median;
  return left.unit_place || right.unit_place;
}

std::string_view units_text(Quantity quantity) {
  switch (quantity) {
    case Quantity::time:
      return "takes s, ms and us only";
    case Quantity::share:
      return "takes % only";
    default:
      return "has no unit";
  }
}

}  // namespace kerf
