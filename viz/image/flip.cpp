#include "viz/image/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

#include "viz/image/compare.h"
#include "viz/image/flip_color.h"

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

/// Correlates with the product of two kernels of odd length, one across and one down. Pixels beyond the
/// border equal those on it.
Channel convolve(const Channel& channel, std::span<const float> across, std::span<const float> down) {
  return convolve_down(convolve_across(channel, across), down);
}

using flip_color::Triple;
using Kernel = std::vector<float>;
using Opponents = std::array<Channel, 3>;

template <class Weight>
Kernel make_kernel(int radius, Weight weight) {
  Kernel kernel;
  for (int x = -radius; x <= radius; ++x) kernel.push_back(static_cast<float>(weight(x)));
  return kernel;
}

/// Each sign's weights are divided by their sum: positive ones add up to 1, negative ones to -1.
void normalize_signs(Kernel& kernel) {
  double positive = 0;
  double negative = 0;
  for (const float weight : kernel) (weight > 0 ? positive : negative) += weight;
  for (float& weight : kernel)
    weight = static_cast<float>(weight > 0 ? weight / positive : -weight / negative);
}

/// One Gaussian of a contrast sensitivity function: weight a, width b (table 1 of the paper).
struct Gaussian {
  double a, b;
};

constexpr double kWidest = 0.04;  // the b that decides the reach of all channels' filters

int csf_radius(double pixels_per_degree) {
  return static_cast<int>(
      std::ceil(3 * std::sqrt(kWidest / (2 * std::numbers::pi * std::numbers::pi)) * pixels_per_degree));
}

double feature_deviation(double pixels_per_degree) { return 0.5 * 0.082 * pixels_per_degree; }

int feature_radius(double pixels_per_degree) {
  return static_cast<int>(std::ceil(3 * feature_deviation(pixels_per_degree)));
}

/// Filters with a sum of Gaussians, each the product of one across and one down, together of weight 1.
Channel filter(const Channel& channel, std::span<const Gaussian> gaussians, double pixels_per_degree) {
  double total = 0;
  std::vector<Kernel> kernels;
  for (const Gaussian& gaussian : gaussians) {
    const Kernel kernel = make_kernel(csf_radius(pixels_per_degree), [&](int x) {
      const double angle = x / pixels_per_degree;
      return std::exp(-std::numbers::pi * std::numbers::pi * angle * angle / gaussian.b);
    });
    double sum = 0;
    for (const float weight : kernel) sum += weight;
    total += gaussian.a * std::sqrt(std::numbers::pi / gaussian.b) * sum * sum;
    kernels.push_back(kernel);
  }
  Channel result(channel.width, channel.height);
  for (std::size_t g = 0; g < kernels.size(); ++g) {
    const double share = gaussians[g].a * std::sqrt(std::numbers::pi / gaussians[g].b) / total;
    Kernel weighted = kernels[g];
    for (float& weight : weighted) weight = static_cast<float>(weight * share);
    const Channel part = convolve(channel, weighted, kernels[g]);
    for (std::size_t i = 0; i < part.values.size(); ++i) result.values[i] += part.values[i];
  }
  return result;
}

Opponents to_opponents(const Image& image, const PixelBounds& part) {
  Opponents result;
  for (Channel& channel : result) channel = Channel(part.right - part.left, part.bottom - part.top);
  for (int y = part.top; y < part.bottom; ++y) {
    for (int x = part.left; x < part.right; ++x) {
      const Triple color = flip_color::ycxcz(flip_color::linear_rgb(image.pixel(x, y)));
      for (std::size_t c = 0; c < 3; ++c) result[c].row(y - part.top)[x - part.left] = color[c];
    }
  }
  return result;
}

/// The colours as far as the eye resolves them, in the space in which they are compared.
std::vector<Triple> perceived_colors(const Opponents& picture, double pixels_per_degree) {
  constexpr std::array<Gaussian, 1> kAchromatic{{{1, 0.0047}}};
  constexpr std::array<Gaussian, 1> kRedGreen{{{1, 0.0053}}};
  constexpr std::array<Gaussian, 2> kBlueYellow{{{34.1, 0.04}, {13.5, 0.025}}};
  const Channel y = filter(picture[0], kAchromatic, pixels_per_degree);
  const Channel cx = filter(picture[1], kRedGreen, pixels_per_degree);
  const Channel cz = filter(picture[2], kBlueYellow, pixels_per_degree);
  std::vector<Triple> result(y.values.size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    Triple rgb = flip_color::linear_rgb_of_ycxcz({y.values[i], cx.values[i], cz.values[i]});
    for (float& value : rgb) value = std::clamp(value, 0.0F, 1.0F);
    result[i] = flip_color::hunt_lab(rgb);
  }
  return result;
}

/// Colour difference from 0 to 1: differences below 40 % of the largest get most of the range (section
/// 4.1.4).
double color_error(const Triple& a, const Triple& b) {
  constexpr double kPower = 0.7;
  constexpr double kKnee = 0.4;
  constexpr double kKneeError = 0.95;
  static const double kLargest = std::pow(
      double{flip_color::hyab(flip_color::hunt_lab({0, 1, 0}), flip_color::hunt_lab({0, 0, 1}))}, kPower);
  const double error = std::pow(double{flip_color::hyab(a, b)}, kPower);
  const double knee = kKnee * kLargest;
  if (error < knee) return kKneeError / knee * error;
  return kKneeError + (error - knee) / (kLargest - knee) * (1 - kKneeError);
}

/// Strength of edges (first derivative) and points (second derivative) in each pixel.
struct Features {
  Channel edges;
  Channel points;
};

Channel gradient(const Channel& y, const Kernel& derivative, const Kernel& smooth) {
  Channel across = convolve(y, derivative, smooth);
  const Channel down = convolve(y, smooth, derivative);
  for (std::size_t i = 0; i < across.values.size(); ++i)
    across.values[i] = std::hypot(across.values[i], down.values[i]);
  return across;
}

Features find_features(const Channel& luminance, double pixels_per_degree) {
  const double deviation = feature_deviation(pixels_per_degree);
  const int radius = feature_radius(pixels_per_degree);
  const auto bell = [&](int x) { return std::exp(-x * x / (2 * deviation * deviation)); };
  Kernel smooth = make_kernel(radius, bell);
  Kernel first = make_kernel(radius, [&](int x) { return -x * bell(x); });
  Kernel second = make_kernel(radius, [&](int x) { return (x * x / (deviation * deviation) - 1) * bell(x); });
  normalize_signs(smooth);
  normalize_signs(first);
  normalize_signs(second);
  Channel y = luminance;
  for (float& value : y.values) value = (value + 16) / 116;
  return {gradient(y, first, smooth), gradient(y, second, smooth)};
}

double feature_error(const Features& a, const Features& b, std::size_t i) {
  const double edge = std::abs(double{a.edges.values[i]} - double{b.edges.values[i]});
  const double point = std::abs(double{a.points.values[i]} - double{b.points.values[i]});
  return std::sqrt(std::max(edge, point) / std::numbers::sqrt2);
}

/// FLIP within a part of the pictures.
Channel errors_within(const Image& reference, const Image& test, const PixelBounds& part, double ppd) {
  const Opponents a = to_opponents(reference, part);
  const Opponents b = to_opponents(test, part);
  const std::vector<Triple> a_colors = perceived_colors(a, ppd);
  const std::vector<Triple> b_colors = perceived_colors(b, ppd);
  const Features a_features = find_features(a[0], ppd);
  const Features b_features = find_features(b[0], ppd);
  Channel errors(a[0].width, a[0].height);
  for (std::size_t i = 0; i < errors.values.size(); ++i) {
    const double color = color_error(a_colors[i], b_colors[i]);
    errors.values[i] = static_cast<float>(std::pow(color, 1 - feature_error(a_features, b_features, i)));
  }
  return errors;
}

}  // namespace

Channel flip_errors(const Image& reference, const Image& test, double pixels_per_degree) {
  const PixelComparison pixels = compare_pixels(reference, test, 0);
  Channel result(reference.width, reference.height);
  if (pixels.same()) return result;
  // A pixel's error depends on the pixels within the filters' reach. Within two reaches around the
  // differences, each pixel either has all that it depends on or sees no difference, and the rest is 0.
  const int margin = 2 * std::max(csf_radius(pixels_per_degree), feature_radius(pixels_per_degree));
  const PixelBounds& seen = pixels.bounds;
  const PixelBounds part{std::max(0, seen.left - margin), std::max(0, seen.top - margin),
                         std::min(reference.width, seen.right + margin),
                         std::min(reference.height, seen.bottom + margin)};
  const Channel errors = errors_within(reference, test, part, pixels_per_degree);
  for (int y = 0; y < errors.height; ++y)
    std::copy_n(errors.row(y), errors.width, result.row(part.top + y) + part.left);
  return result;
}

FlipSummary summarize_flip(const Channel& errors, std::size_t worst) {
  constexpr int kApart = 16;
  FlipSummary summary;
  double sum = 0;
  std::vector<FlipPixel> pixels;
  for (int y = 0; y < errors.height; ++y) {
    for (int x = 0; x < errors.width; ++x) {
      const double error = errors.row(y)[x];
      sum += error;
      if (error > 0) pixels.push_back({x, y, error});
    }
  }
  summary.mean = errors.values.empty() ? 0 : sum / static_cast<double>(errors.values.size());
  while (!pixels.empty() && summary.worst.size() < worst) {
    const FlipPixel next = *std::ranges::max_element(pixels, {}, &FlipPixel::error);
    summary.worst.push_back(next);
    std::erase_if(pixels, [&](const FlipPixel& pixel) {
      return std::abs(pixel.x - next.x) < kApart && std::abs(pixel.y - next.y) < kApart;
    });
  }
  if (!summary.worst.empty()) summary.max = summary.worst.front().error;
  return summary;
}

}  // namespace kerf
