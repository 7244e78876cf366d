#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "viz/draw/camera.h"

namespace kerf {

/// How much of the picture lines cover, from place to place. Where they are many, each of them fades, so that
/// together they are as dark as a few and what they join is seen.
///
/// Sums are spread over the four nearest of a grid of places and read back likewise, so that a line which
/// moves a little fades a little.
class PairDensity {
 public:
  explicit PairDensity(const View& view);

  /// Takes in a line of so many pixels of area with its middle there.
  void add(const Eigen::Vector2d& middle, double area);
  /// What is left of the opacity and the width of a line with its middle there: 1 where lines are few.
  [[nodiscard]] double strength(const Eigen::Vector2d& middle) const;

 private:
  struct Place {
    std::size_t index;
    double share;
  };
  [[nodiscard]] std::array<Place, 4> places_around(const Eigen::Vector2d& pixel) const;

  double pitch_;  ///< pixels between places
  std::size_t columns_;
  std::size_t rows_;
  std::vector<double> areas_;
};

}  // namespace kerf
