#pragma once

#include <array>
#include <cstddef>

namespace kerf {

/// A number and what rounding took from it: their sum is exact.
struct Exact {
  double value = 0;
  double rest = 0;
};

/// a - b. Exact as long as the result is finite (Knuth's two-sum).
constexpr Exact difference(double a, double b) {
  const double value = a - b;
  const double b_part = a - value;
  const double a_part = value + b_part;
  return {value, (a - a_part) + (b_part - b)};
}

/// A sum without rounding, as doubles that do not overlap (Shewchuk, "Adaptive precision floating-point
/// arithmetic and fast robust geometric predicates", 1997). For numbers between 2^-400 and 2^400, of which
/// products are exact, too.
class ExactSum {
 public:
  void add(double x);
  /// Adds a * b.
  void add_product(double a, double b);
  void add_product(const Exact& a, const Exact& b);
  /// -1, 0 or 1.
  [[nodiscard]] int sign() const;

 private:
  static constexpr std::size_t kMost = 48;
  std::array<double, kMost> parts_{};  ///< by growing magnitude, none 0
  std::size_t size_ = 0;
};

}  // namespace kerf
