#include "core/query/expression.h"

#include <algorithm>
#include <array>

#include "core/base/float_mode.h"
#include "core/query/expression_lexer.h"
#include "core/query/expression_units.h"
#include "core/query/expression_words.h"

namespace kerf {
namespace {

using Kind = ExpressionPart::Kind;

struct Infix {
  std::string_view symbol;
  Kind kind;
  int strength;
};
constexpr std::array kInfixes{
    Infix{"||", Kind::either, 1},        Infix{"&&", Kind::both, 2},
    Infix{"==", Kind::equal, 3},         Infix{"=", Kind::equal, 3},
    Infix{"!=", Kind::unequal, 3},       Infix{"<=", Kind::less_equal, 3},
    Infix{">=", Kind::greater_equal, 3}, Infix{"<", Kind::less, 3},
    Infix{">", Kind::greater, 3},        Infix{"+", Kind::add, 4},
    Infix{"-", Kind::subtract, 4},       Infix{"*", Kind::multiply, 5},
    Infix{"/", Kind::divide, 5},
};

/// A pair, plane, node or object in a condition, and the words that may follow.
struct Subject {
  std::string_view name;
  std::string_view verb;  ///< empty: none follows
  Happening happening;
};
constexpr std::array kSubjects{
    Subject{"pair", "enters", Happening::pair_enters}, Subject{"pair", "leaves", Happening::pair_leaves},
    Subject{"pair", "", Happening::pair_is},           Subject{"plane", "moves", Happening::plane_moves},
    Subject{"node", "", Happening::node_changes},      Subject{"object", "moves", Happening::object_moves},
};

constexpr ExpressionMeasure kTruth{ExpressionMeasure::Quantity::plain, {}};

bool is_comparison(Kind kind) { return kind >= Kind::less && kind <= Kind::unequal; }

/// Of which the recording has a number for each step.
bool has_median(Variable variable) { return variable <= Variable::sweep_time; }

bool is_named(Variable variable) {
  return variable == Variable::op || variable == Variable::kind || variable == Variable::phase;
}

/// Precedence climbing over the tokens; operands are appended before their operators. Nesting is limited,
/// since it costs stack.
class Parser {
 public:
  explicit Parser(std::string_view text) : text_(text), tokens_(tokens_of(text)) {}

  std::vector<ExpressionPart> run_condition() {
    parse_all();
    require_condition(parts_.size() - 1, 0);
    return std::move(parts_);
  }

  std::vector<ExpressionPart> run() {
    parse_all();
    return std::move(parts_);
  }

 private:
  void parse_all() {
    infix(1);
    if (now().kind != Token::Kind::end) reject("here an operator such as && was expected");
  }
  void require_condition(std::size_t part, std::size_t place) const {
    const Kind kind = parts_[part].kind;
    if (kind != Kind::happening && kind != Kind::is_not && kind < Kind::less)
      reject_expression(text_, place, "this is a number, not a condition; compare it with something");
  }
  [[nodiscard]] const Token& now() const { return tokens_[next_]; }
  [[noreturn]] void reject(std::string_view what) const { reject_expression(text_, now().place, what); }

  bool accept(std::string_view text) {
    if (now().kind == Token::Kind::end || now().text != text) return false;
    ++next_;
    return true;
  }
  void expect(std::string_view text) {
    if (!accept(text)) reject("here '" + std::string(text) + "' was expected");
  }
  /// A chain of operators nests, too, and each takes room on the stack where it is evaluated.
  std::size_t add(const ExpressionPart& part, const ExpressionMeasure& measure) {
    constexpr std::size_t kMost = 10'000;
    if (parts_.size() == kMost) reject("more than 10,000 values and operators are too many");
    parts_.push_back(part);
    measures_.push_back(measure);
    return parts_.size() - 1;
  }

  /// One side of an operator: its parts, the last of which is the whole, and its text.
  struct Operand {
    std::size_t first_part;
    std::size_t part;
    std::size_t begin;
    std::size_t end;
  };

  /// Parses operands joined by operators that bind at least that strongly; returns the index of the whole.
  std::size_t infix(int strength) {
    const std::size_t begin = now().place;
    const std::size_t first_part = parts_.size();
    std::size_t left = prefix();
    for (;;) {
      const auto found = std::ranges::find(kInfixes, now().text, &Infix::symbol);
      if (now().kind != Token::Kind::symbol || found == kInfixes.end() || found->strength < strength)
        return left;
      const std::size_t place = now().place;
      ++next_;
      check_names(*found, left, place);
      const std::size_t begin_of_right = now().place;
      const std::size_t right = found->kind == Kind::equal || found->kind == Kind::unequal
                                    ? named_or_infix(left, found->strength + 1)
                                    : infix(found->strength + 1);
      if (found->kind >= Kind::both) {
        require_condition(left, begin);
        require_condition(right, begin_of_right);
      }
      check_units(found->kind, {first_part, left, begin, place},
                  {left + 1, right, begin_of_right, now().place});
      left = add({.kind = found->kind, .left = left, .right = right},
                 joined(found->kind, measures_[left], measures_[right]));
      if (is_comparison(found->kind)) refuse_chain();
    }
  }

  void check_units(Kind kind, const Operand& left, const Operand& right) const {
    if (!is_misfit(kind, measures_[left.part], measures_[right.part])) return;
    if (measures_[right.part].unit_place) refuse_unit(right, left);
    refuse_unit(left, right);
  }

  /// The unit of `written` does not fit `other`.
  [[noreturn]] void refuse_unit(const Operand& written, const Operand& other) const {
    std::string name(text_.substr(other.begin, other.end - other.begin));
    name.resize(name.find_last_not_of(" \t") + 1);
    name += " " + std::string(units_text(measures_[other.part].quantity));
    const ExpressionMeasure& measure = measures_[written.part];
    reject_expression(text_, *measure.unit_place,
                      measure.is_of_median ? "median alone is that of step_time, but " + name +
                                                 "; write median(" + word_with_median(other) + ")"
                                           : "this unit does not fit: " + name);
  }

  /// The first word that has a median, or WORD.
  [[nodiscard]] std::string word_with_median(const Operand& in) const {
    for (std::size_t part = in.first_part; part <= in.part; ++part) {
      if (parts_[part].kind != Kind::variable || !has_median(parts_[part].variable)) continue;
      return std::string(
          std::ranges::find(variable_words(), parts_[part].variable, &VariableWord::variable)->name);
    }
    return "WORD";
  }

  /// Who writes 1<height<5 means that height is between the two.
  void refuse_chain() const {
    const auto next = std::ranges::find(kInfixes, now().text, &Infix::symbol);
    if (now().kind == Token::Kind::symbol && next != kInfixes.end() && is_comparison(next->kind))
      reject("a comparison cannot be compared; write 100<height && height<200");
  }

  /// Only == and != make sense for names.
  void check_names(const Infix& infix, std::size_t left, std::size_t place) const {
    const ExpressionPart& part = parts_[left];
    if (part.kind != Kind::variable || !is_named(part.variable)) return;
    if (infix.kind != Kind::equal && infix.kind != Kind::unequal)
      reject_expression(text_, place, "a name can only be compared by == or !=");
  }

  /// After `op ==`, `kind ==` or `phase ==` comes one of their names or an expression.
  std::size_t named_or_infix(std::size_t left, int strength) {
    const ExpressionPart part = parts_[left];
    if (part.kind != Kind::variable || !is_named(part.variable)) return infix(strength);
    std::string name(now().text);
    std::ranges::replace(name, '-', '_');
    std::string known;
    for (const NamedValue& value : named_values()) {
      if (value.of != part.variable) continue;
      if (value.name == name) {
        ++next_;
        return add({.kind = Kind::number, .number = ConditionNumber::measured(value.value)}, {});
      }
      known += (known.empty() ? "" : ", ") + std::string(value.name);
    }
    reject("here one of these was expected: " + known);
  }

  std::size_t prefix() {
    constexpr int kDeepest = 100;
    if (++depth_ > kDeepest) reject("this is nested too deeply");
    const std::size_t part = prefix_unlimited();
    --depth_;
    return part;
  }

  std::size_t prefix_unlimited() {
    constexpr int kTightest = 6;
    if (accept("!")) return negation();
    if (accept("-")) {
      const std::size_t inner = infix(kTightest);
      return add({.kind = Kind::negate, .left = inner}, measures_[inner]);
    }
    if (accept("(")) {
      const std::size_t inner = infix(1);
      expect(")");
      return inner;
    }
    if (now().kind == Token::Kind::number) {
      const Token& token = tokens_[next_++];
      return add({.kind = Kind::number, .number = token.number}, token.measure);
    }
    if (now().kind == Token::Kind::word) return word();
    reject("here a name, a number or '(' was expected");
  }

  std::size_t negation() {
    const std::size_t place = now().place;
    const std::size_t inner = infix(3);
    require_condition(inner, place);
    return add({.kind = Kind::is_not, .left = inner}, kTruth);
  }

  std::size_t word() {
    const bool has_arguments = tokens_[next_ + 1].text == "(";
    if (accept("median")) return median();
    if (has_arguments) return happening();
    const VariableWord* const found = find_variable();
    if (found == nullptr) reject_word();
    ++next_;
    return add({.kind = Kind::variable, .variable = found->variable}, measure_of(found->variable));
  }

  /// `median` alone is that of the step's time.
  std::size_t median() {
    const std::size_t place = tokens_[next_ - 1].place;
    if (!accept("("))
      return add({.kind = Kind::median, .variable = Variable::step_time},
                 {ExpressionMeasure::Quantity::time, place, true});
    const VariableWord* const found = find_variable();
    if (found == nullptr) reject_word();
    const Variable of = found->variable;
    if (!has_median(of)) reject("only what steps have in the recording has a median");
    ++next_;
    expect(")");
    return add({.kind = Kind::median, .variable = of}, measure_of(of));
  }

  [[nodiscard]] const VariableWord* find_variable() const {
    const auto found = std::ranges::find(variable_words(), now().text, &VariableWord::name);
    return found == variable_words().end() ? nullptr : &*found;
  }

  [[noreturn]] void reject_word() const {
    std::string known;
    for (const VariableWord& word : variable_words())
      known += (known.empty() ? "" : ", ") + std::string(word.name);
    reject("'" + std::string(now().text) +
           "' is not known; known are pair(i,j), plane(nK), node(nK), object(i), median, " + known);
  }

  std::size_t happening() {
    const std::string_view name = now().text;
    if (std::ranges::find(kSubjects, name, &Subject::name) == kSubjects.end()) reject_word();
    ++next_;
    ExpressionPart part{.kind = Kind::happening};
    expect("(");
    const bool is_node = name == "plane" || name == "node";
    part.a = is_node ? node() : object();
    if (name == "pair") {
      expect(",");
      const std::size_t second = now().place;
      part.b = object();
      if (part.a == part.b) reject_expression(text_, second, "an object makes no pair with itself");
    }
    expect(")");
    std::string verbs;
    for (const Subject& subject : kSubjects) {
      if (subject.name != name) continue;
      part.happening = subject.happening;
      if (subject.verb.empty() || accept(subject.verb)) return add(part, kTruth);
      verbs += (verbs.empty() ? "" : " or ") + std::string(subject.verb);
    }
    reject("here " + verbs + " was expected");
  }

  /// A number of a node, with or without its letter: 17 or n17.
  GivenId node() {
    std::string_view text = now().text;
    if (text.starts_with("n")) text.remove_prefix(1);
    const auto id = parse_given_id(text);
    if (!id || id->magnitude >= UINT32_MAX) reject("here a number such as 17 or n17 was expected");
    ++next_;
    return *id;
  }

  /// What an object is called, which may be less than 0.
  GivenId object() {
    const bool is_negative = accept("-");
    const auto id = parse_given_id((is_negative ? "-" : "") + std::string(now().text));
    if (!id || now().kind != Token::Kind::number)
      reject("here the number of an object, such as 17, was expected");
    ++next_;
    return *id;
  }

  std::string_view text_;
  std::vector<Token> tokens_;
  std::size_t next_ = 0;
  int depth_ = 0;
  std::vector<ExpressionPart> parts_;
  std::vector<ExpressionMeasure> measures_;  ///< one a part
};

}  // namespace

Expression Expression::parse(std::string_view text) {
  const DefaultFloats floats;
  Expression expression;
  expression.text_ = text;
  expression.parts_ = Parser(text).run_condition();
  return expression;
}

Expression Expression::parse_value(std::string_view text) {
  const DefaultFloats floats;
  Expression expression;
  expression.text_ = text;
  expression.parts_ = Parser(text).run();
  return expression;
}

bool Expression::has(bool (*wanted)(const ExpressionPart&)) const {
  return std::ranges::any_of(parts_, wanted);
}

bool Expression::asks_events() const {
  return has([](const ExpressionPart& part) {
    return (part.kind == Kind::variable && part.variable >= Variable::event) ||
           (part.kind == Kind::happening && part.happening >= Happening::plane_moves);
  });
}

bool Expression::asks_pairs() const {
  return has([](const ExpressionPart& part) {
    return part.kind == Kind::happening && part.happening <= Happening::pair_leaves;
  });
}

bool Expression::asks_oracle() const {
  return has([](const ExpressionPart& part) {
    return part.kind == Kind::variable && part.variable >= Variable::missed &&
           part.variable <= Variable::undecided;
  });
}

bool Expression::asks_depth() const {
  return has([](const ExpressionPart& part) {
    return part.kind == Kind::variable && part.variable == Variable::depth;
  });
}

}  // namespace kerf
