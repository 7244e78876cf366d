#include "core/query/expression_lexer.h"

#include <array>
#include <charconv>
#include <stdexcept>
#include <string>

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
  void add(Token::Kind kind, std::size_t size, double number = 0) {
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
      add(Token::Kind::number, size, value * unit.factor);
      if (!name.empty()) tokens_.back().measure = {unit.quantity, at_ - name.size()};
      return;
    }
    reject_expression(text_, at_ + digits, "this is no unit; known are s, ms, us and %");
  }

  void word() {
    std::size_t size = 1;
    const auto at = [&](std::size_t offset) {
      return at_ + offset < text_.size() ? text_[at_ + offset] : ' ';
    };
    while (is_letter(at(size)) || is_digit(at(size)) || (at(size) == '-' && is_letter(at(size + 1)))) ++size;
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
