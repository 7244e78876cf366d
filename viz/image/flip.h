#pragma once

#include <cstddef>
#include <vector>

#include "viz/image/image.h"

namespace kerf {

/// One number a pixel, rows from the top down.
struct Channel {
  int width = 0;
  int height = 0;
  std::vector<float> values;

  Channel() = default;
  Channel(int columns, int rows)
      : width(columns),
        height(rows),
        values(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) {}
  [[nodiscard]] float* row(int y) {
    return values.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
  }
  [[nodiscard]] const float* row(int y) const {
    return values.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
  }
};

/// An observer 0.7 m before a screen that shows 3840 pixels on 0.7 m: FLIP's own default.
inline constexpr double kFlipPixelsPerDegree = 67.02064327658226;

/// LDR-FLIP (Andersson, Nilsson, Akenine-Moeller, Oskarsson, Astroem, Fairchild: "FLIP: A Difference
/// Evaluator for Alternating Images", HPG 2020): how much a person notices at each pixel when the two
/// pictures alternate, 0 to 1. Transparent pixels are laid over white. Throws std::invalid_argument if the
/// sizes differ.
Channel flip_errors(const Image& reference, const Image& test,
                    double pixels_per_degree = kFlipPixelsPerDegree);

struct FlipPixel {
  int x = 0;
  int y = 0;
  double error = 0;
};

struct FlipSummary {
  double max = 0;
  double mean = 0;
  std::vector<FlipPixel> worst;  ///< worst first, none within 16 pixels of a worse one, none without error
};

FlipSummary summarize_flip(const Channel& errors, std::size_t worst = 5);

/// The errors as colours of the map "magma": black without, light yellow at 1.
Image heat_map(const Channel& errors);

}  // namespace kerf
