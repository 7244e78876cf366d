#pragma once

#include <cstddef>
#include <span>
#include <vector>

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

/// Correlates with the product of two kernels of odd length, one across and one down. Pixels beyond the
/// border equal those on it.
Channel convolve(const Channel& channel, std::span<const float> across, std::span<const float> down);

}  // namespace kerf
