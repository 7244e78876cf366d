#pragma once

#include <string>
#include <vector>

namespace kerf {

/// An axis of a plot that holds given values, with a place for zeros if it is logarithmic.
class Axis {
 public:
  Axis(const std::vector<double>& values, bool log);

  /// The position of a value: the value itself, or the place of zeros.
  [[nodiscard]] double place(double value) const;
  /// From 0 to 1 along the axis.
  [[nodiscard]] double share(double value) const;
  /// Range, scale and tics of gnuplot's axis "x" or "y".
  [[nodiscard]] std::string script(const std::string& axis) const;

 private:
  [[nodiscard]] std::string log_tics() const;

  bool log_ = false;
  bool has_zero_ = false;
  double zero_ = 0;  ///< where zeros stand
  double first_tic_ = 0;
  double low_ = 0;
  double high_ = 1;
};

}  // namespace kerf
