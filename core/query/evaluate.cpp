#include "core/query/evaluate.h"

#include <cmath>

namespace kerf {
namespace {

using Kind = ExpressionPart::Kind;

class Evaluation {
 public:
  Evaluation(const Expression& expression, const Moment& moment)
      : parts_(expression.parts()), moment_(moment) {}

  [[nodiscard]] double value(const ExpressionPart& part) const {
    switch (part.kind) {
      case Kind::number:
        return part.number;
      case Kind::variable:
        return moment_.number(part.variable);
      case Kind::median:
        return moment_.median(part.variable);
      case Kind::happening:
        return moment_.happens(part) ? 1 : 0;
      case Kind::negate:
        return -value(parts_[part.left]);
      case Kind::is_not:
        return truth(part.left) ? 0 : 1;
      case Kind::both:
        return truth(part.left) && truth(part.right) ? 1 : 0;
      case Kind::either:
        return truth(part.left) || truth(part.right) ? 1 : 0;
      default:
        return joined(part.kind, value(parts_[part.left]), value(parts_[part.right]));
    }
  }

 private:
  [[nodiscard]] bool truth(std::size_t part) const {
    const double x = value(parts_[part]);
    return !std::isnan(x) && x != 0;
  }

  static double joined(Kind kind, double x, double y) {
    if (kind == Kind::multiply) return x * y;
    if (kind == Kind::divide) return x / y;
    if (kind == Kind::add) return x + y;
    if (kind == Kind::subtract) return x - y;
    return compares(kind, x, y) ? 1 : 0;
  }

  static bool compares(Kind kind, double x, double y) {
    if (std::isnan(x) || std::isnan(y)) return false;
    switch (kind) {
      case Kind::less:
        return x < y;
      case Kind::less_equal:
        return x <= y;
      case Kind::greater:
        return x > y;
      case Kind::greater_equal:
        return x >= y;
      case Kind::equal:
        return x == y;
      default:
        return x != y;
    }
  }

  std::span<const ExpressionPart> parts_;
  const Moment& moment_;
};

}  // namespace

bool holds(const Expression& expression, const Moment& moment) {
  const double x = value(expression, moment);
  return !std::isnan(x) && x != 0;
}

double value(const Expression& expression, const Moment& moment) {
  return Evaluation(expression, moment).value(expression.root());
}

}  // namespace kerf
