#include "core/query/evaluate.h"

namespace kerf {
namespace {

using Kind = ExpressionPart::Kind;

class Evaluation {
 public:
  Evaluation(const Expression& expression, const Moment& moment)
      : parts_(expression.parts()), moment_(moment) {}

  [[nodiscard]] ConditionNumber value(const ExpressionPart& part) const {
    switch (part.kind) {
      case Kind::number:
        return part.number;
      case Kind::variable:
        return moment_.number(part.variable);
      case Kind::median:
        return moment_.median(part.variable);
      case Kind::happening:
        return of_truth(moment_.happens(part));
      case Kind::negate:
        return negated(value(parts_[part.left]));
      case Kind::is_not:
        return of_truth(!truth(part.left));
      case Kind::both:
        return of_truth(truth(part.left) && truth(part.right));
      case Kind::either:
        return of_truth(truth(part.left) || truth(part.right));
      default:
        return joined(part.kind, value(parts_[part.left]), value(parts_[part.right]));
    }
  }

 private:
  [[nodiscard]] bool truth(std::size_t part) const { return value(parts_[part]).is_true(); }

  static ConditionNumber of_truth(bool truth) { return ConditionNumber::of(truth ? 1 : 0); }

  static ConditionNumber negated(const ConditionNumber& x) {
    return {-x.nearest, x.exact ? std::optional(-*x.exact) : std::nullopt};
  }

  static ConditionNumber joined(Kind kind, const ConditionNumber& x, const ConditionNumber& y) {
    if (kind == Kind::divide) return ConditionNumber::measured(x.nearest / y.nearest);
    if (kind < Kind::less) return calculated(kind, x, y);
    return of_truth(x.exists() && y.exists() &&
                    ConditionNumber::related(
                        x, y, [kind](long double a, long double b) { return compares(kind, a, b); }));
  }

  static ConditionNumber calculated(Kind kind, const ConditionNumber& x, const ConditionNumber& y) {
    const auto calculate = [kind]<class Number>(Number a, Number b) {
      if (kind == Kind::multiply) return a * b;
      return kind == Kind::add ? a + b : a - b;
    };
    return x.exact && y.exact ? ConditionNumber::of(calculate(*x.exact, *y.exact))
                              : ConditionNumber::measured(calculate(x.nearest, y.nearest));
  }

  static bool compares(Kind kind, long double x, long double y) {
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

bool holds(const Expression& expression, const Moment& moment) { return value(expression, moment).is_true(); }

ConditionNumber value(const Expression& expression, const Moment& moment) {
  return Evaluation(expression, moment).value(expression.root());
}

}  // namespace kerf
