#include "viz/draw/pair_density.h"

#include <algorithm>
#include <cmath>

namespace kerf {
namespace {

constexpr double kRows = 22.5;      ///< of places in a picture
constexpr double kFewLines = 0.11;  ///< share of the picture that lines may cover before they fade
constexpr double kWeakest = 0.4;    ///< a line remains a line

}  // namespace

PairDensity::PairDensity(const View& view)
    : pitch_(view.picture_height / kRows),
      columns_(static_cast<std::size_t>(view.picture_width / pitch_) + 2),
      rows_(static_cast<std::size_t>(view.picture_height / pitch_) + 2),
      areas_(columns_ * rows_) {}

std::array<PairDensity::Place, 4> PairDensity::places_around(const Eigen::Vector2d& pixel) const {
  const double x = std::clamp(pixel.x() / pitch_, 0.0, static_cast<double>(columns_) - 1.001);
  const double y = std::clamp(pixel.y() / pitch_, 0.0, static_cast<double>(rows_) - 1.001);
  const auto column = static_cast<std::size_t>(x);
  const auto row = static_cast<std::size_t>(y);
  const double right = x - static_cast<double>(column);
  const double below = y - static_cast<double>(row);
  const std::size_t first = row * columns_ + column;
  return {{{first, (1 - right) * (1 - below)},
           {first + 1, right * (1 - below)},
           {first + columns_, (1 - right) * below},
           {first + columns_ + 1, right * below}}};
}

void PairDensity::add(const Eigen::Vector2d& middle, double area) {
  for (const auto& [index, share] : places_around(middle)) areas_[index] += share * area;
}

double PairDensity::strength(const Eigen::Vector2d& middle) const {
  double area = 0;
  for (const auto& [index, share] : places_around(middle)) area += share * areas_[index];
  const double covered = area / (pitch_ * pitch_);
  return covered <= kFewLines ? 1.0 : std::max(kWeakest, std::sqrt(kFewLines / covered));
}

}  // namespace kerf
