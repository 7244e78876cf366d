#include "core/related/principal_axes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace kerf {
namespace {

template <int D>
using Matrix = std::array<std::array<double, D>, D>;

/// The means in `mean`, which are those of doubles.
template <int D>
Matrix<D> covariance(std::span<const Vector<D>> points, std::array<double, D>& mean) {
  mean.fill(0);
  for (const Vector<D>& point : points)
    for (std::size_t i = 0; i < D; ++i) mean[i] += double{point.value[i]};
  for (double& x : mean) x /= static_cast<double>(points.size());
  Matrix<D> matrix{};
  for (const Vector<D>& point : points)
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t k = 0; k < D; ++k)
        matrix[i][k] += (double{point.value[i]} - mean[i]) * (double{point.value[k]} - mean[k]);
  return matrix;
}

/// Turns the axes i and k so that the matrix has a zero there (Jacobi 1846).
template <int D>
void rotate(Matrix<D>& matrix, Matrix<D>& axes, std::size_t i, std::size_t k) {
  if (matrix[i][k] == 0) return;
  const double theta = (matrix[k][k] - matrix[i][i]) / (2 * matrix[i][k]);
  const double t = std::copysign(1.0, theta) / (std::abs(theta) + std::hypot(1.0, theta));
  const double c = 1 / std::hypot(1.0, t);
  const double s = t * c;
  const auto turn = [&](double& a, double& b) {
    const double old = a;
    a = c * a - s * b;
    b = s * old + c * b;
  };
  for (std::size_t j = 0; j < D; ++j) turn(matrix[j][i], matrix[j][k]);
  for (std::size_t j = 0; j < D; ++j) turn(matrix[i][j], matrix[k][j]);
  for (std::size_t j = 0; j < D; ++j) turn(axes[j][i], axes[j][k]);
}

}  // namespace

template <int D>
PrincipalAxes<D> principal_axes(std::span<const Vector<D>> points) {
  constexpr int kSweeps = 12;  // far more than three rows need
  std::array<double, D> mean{};
  Matrix<D> matrix = covariance<D>(points, mean);
  Matrix<D> axes{};
  for (std::size_t i = 0; i < D; ++i) axes[i][i] = 1;
  for (int sweep = 0; sweep < kSweeps; ++sweep)
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t k = i + 1; k < D; ++k) rotate<D>(matrix, axes, i, k);
  std::array<std::size_t, D> order{};
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return matrix[a][a] > matrix[b][b]; });
  PrincipalAxes<D> result;
  for (std::size_t i = 0; i < D; ++i) {
    result.mean.value[i] = static_cast<Scalar>(mean[i]);
    for (std::size_t j = 0; j < D; ++j)
      result.axes[i].value[j] = static_cast<Scalar>(std::clamp(axes[j][order[i]], -1.0, 1.0));
  }
  return result;
}

template PrincipalAxes<2> principal_axes(std::span<const Vector<2>>);
template PrincipalAxes<3> principal_axes(std::span<const Vector<3>>);

}  // namespace kerf
