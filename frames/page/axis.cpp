#include "frames/page/axis.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "frames/page/gnuplot.h"
#include "frames/page/short_number.h"

namespace kerf {
namespace {

constexpr double kManyDecades = 2.5;
constexpr double kFewDecades = 0.8;
constexpr double kZeroRoom = 0.08;  ///< of the axis, between zeros and the least other value

std::vector<double> digits_for(double decades) {
  if (decades > kManyDecades) return {1};
  if (decades > kFewDecades) return {1, 2, 5};
  return {1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8};
}

}  // namespace

Axis::Axis(const std::vector<double>& values, bool log) : log_(log) {
  double least = std::numeric_limits<double>::max();
  double most = std::numeric_limits<double>::lowest();
  for (const double value : values) {
    has_zero_ |= log && value <= 0;
    if (log && value <= 0) continue;
    least = std::min(least, value);
    most = std::max(most, value);
  }
  if (least > most) least = most = log ? 1 : 0;
  if (log) {
    zero_ = least / std::max(4.0, std::pow(most / least, kZeroRoom));
    low_ = has_zero_ ? zero_ / 1.6 : least / 1.3;
    high_ = most * 1.4;
    first_tic_ = has_zero_ ? least * 0.999 : low_;
    return;
  }
  const double room = most > least ? 0.06 * (most - least) : 1;
  low_ = least >= 0 && least < most / 2 ? 0 : least - room;
  high_ = most + room;
}

double Axis::place(double value) const { return log_ && value <= 0 ? zero_ : value; }

double Axis::share(double value) const {
  const double at = place(value);
  return log_ ? std::log(at / low_) / std::log(high_ / low_) : (at - low_) / (high_ - low_);
}

/// Powers of ten, and the more tics between them the fewer there are.
std::string Axis::log_tics() const {
  std::string tics = has_zero_ ? "\"0\" " + plot_number(zero_) : "";
  for (int power = static_cast<int>(std::floor(std::log10(low_))); std::pow(10, power) <= high_; ++power)
    for (const double digit : digits_for(std::log10(high_ / low_))) {
      const double at = std::stod(plot_number(digit) + "e" + std::to_string(power));
      if (at < first_tic_ || at > high_) continue;
      tics += (tics.empty() ? "" : ", ") + in_quotes(short_number(at)) + " " + plot_number(at);
    }
  return tics;
}

std::string Axis::script(const std::string& axis) const {
  std::string text = "set " + axis + "range [" + plot_number(low_) + ":" + plot_number(high_) + "]\n";
  if (log_) text += "set logscale " + axis + "\nset " + axis + "tics (" + log_tics() + ")\n";
  return text;
}

}  // namespace kerf
