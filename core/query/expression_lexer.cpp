#include "core/query/expression_lexer.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <stdexcept>
#include <string>

#include "core/base/number_text.h"
#include "core/query/expression_words.h"

namespace kerf {
namespace {

constexpr std::array<std::string_view, 17> kSymbols{"&&", "||", "==", "!=", "<=", ">=", "<", ">", "!",
                                                    "+",  "-",  "*",  "/",  "(",  ")",  ",", "="};

struct Unit {
  std::string_view name;
  double factor;
  ExpressionMeasure::Quantity quantity;
};
constexpr std::array kUnits{
    Unit{"", 1, ExpressionMeasure::Quantity::bare},      Unit{"s", 1, ExpressionMeasure::Quantity::time},
    Unit{"ms", 1e-3, ExpressionMeasure::Quantity::time}, Unit{"us", 1e-6, ExpressionMeasure::Quantity::time},
    Unit{"%", 1e-2, ExpressionMeasure::Quantity::share},
};

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Whether it names a value, with a hyphen for the underscore.
bool is_value(std::string_view hyphenated) {
  std::string name(hyphenated);
  std::ranges::replace(name, '-', '_');
  return std::ranges::find(named_values(), name, &NamedValue::name) != named_values().end();
}

class Lexer {
 public:
  explicit Lexer(std::string_view text) : text_(text) {}

  std::vector<Token> run() {
    for (;;) {
      while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
      if (at_ == text_.size()) break;
      if (is_digit(text_[at_]) || text_[at_] == '.') {
        number();
      } else if (is_letter(text_[at_])) {
        word();
      } else {
        symbol();
      }
    }
    tokens_.push_back({.place = at_});
    return std::move(tokens_);
  }

 private:
  void add(Token::Kind kind, std::size_t size, const ConditionNumber& number = {}) {
    tokens_.push_back({.kind = kind, .text = text_.substr(at_, size), .number = number, .place = at_});
    at_ += size;
  }

  void number() {
    double value = 0;
    const char* const begin = text_.data() + at_;
    const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
    if (error != std::errc{}) reject_expression(text_, at_, "this is no number");
    const auto digits = static_cast<std::size_t>(end - begin);
    std::size_t size = digits;
    while (at_ + size < text_.size() && (is_letter(text_[at_ + size]) || text_[at_ + size] == '%')) ++size;
    const std::string_view name = text_.substr(at_ + digits, size - digits);
    for (const Unit& unit : kUnits) {
      if (unit.name != name) continue;
      const std::string_view written = text_.substr(at_, digits);
      add(Token::Kind::number, size,
          {value * unit.factor, name.empty() ? read_number<long double>(written) : std::nullopt});
      if (!name.empty()) tokens_.back().measure = {unit.quantity, at_ - name.size()};
      return;
    }
    reject_expression(text_, at_ + digits, "this is no unit; known are s, ms, us and %");
  }

  /// How many letters and digits begin there.
  [[nodiscard]] std::size_t letters(std::size_t offset) const {
    const std::string_view rest = text_.substr(at_ + offset);
    const auto is_other = [](char c) { return !is_letter(c) && !is_digit(c); };
    return static_cast<std::size_t>(std::ranges::find_if(rest, is_other) - rest.begin());
  }

  void word() {
    std::size_t size = letters(0);
    if (text_.substr(at_ + size).starts_with('-')) {
      const std::size_t both = size + 1 + letters(size + 1);
      if (is_value(text_.substr(at_, both))) size = both;
    }
    add(Token::Kind::word, size);
  }

  void symbol() {
    for (const std::string_view symbol : kSymbols)
      if (text_.substr(at_).starts_with(symbol)) return add(Token::Kind::symbol, symbol.size());
    reject_expression(text_, at_, "this means nothing here");
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::vector<Token> tokens_;
};

}  // namespace

std::vector<Token> tokens_of(std::string_view text) { return Lexer(text).run(); }

void reject_expression(std::string_view text, std::size_t place, std::string_view what) {
  throw std::invalid_argument("expression: " + std::string(what) + "\n  " + std::string(text) + "\n  " +
                              std::string(place, ' ') + "^");
}

}  // namespace kerf
