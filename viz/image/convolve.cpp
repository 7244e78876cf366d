#include "viz/image/convolve.h"

#include <algorithm>

namespace kerf {
namespace {

Channel convolve_across(const Channel& channel, std::span<const float> kernel) {
  const auto width = static_cast<std::size_t>(channel.width);
  const std::size_t radius = kernel.size() / 2;
  Channel result(channel.width, channel.height);
  std::vector<float> padded(width + 2 * radius);
  for (int y = 0; y < channel.height; ++y) {
    const float* row = channel.row(y);
    std::fill_n(padded.begin(), radius, row[0]);
    std::copy_n(row, width, padded.begin() + static_cast<std::ptrdiff_t>(radius));
    std::fill_n(padded.end() - static_cast<std::ptrdiff_t>(radius), radius, row[width - 1]);
    float* out = result.row(y);
    for (std::size_t k = 0; k < kernel.size(); ++k)
      for (std::size_t x = 0; x < width; ++x) out[x] += kernel[k] * padded[x + k];
  }
  return result;
}

Channel convolve_down(const Channel& channel, std::span<const float> kernel) {
  const int radius = static_cast<int>(kernel.size() / 2);
  Channel result(channel.width, channel.height);
  for (int y = 0; y < channel.height; ++y) {
    float* out = result.row(y);
    for (int k = -radius; k <= radius; ++k) {
      const float weight = kernel[static_cast<std::size_t>(k + radius)];
      const float* row = channel.row(std::clamp(y + k, 0, channel.height - 1));
      for (int x = 0; x < channel.width; ++x) out[x] += weight * row[x];
    }
  }
  return result;
}

}  // namespace

Channel convolve(const Channel& channel, std::span<const float> across, std::span<const float> down) {
  return convolve_down(convolve_across(channel, across), down);
}

}  // namespace kerf
