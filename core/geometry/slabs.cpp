#include "core/geometry/slabs.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kerf {
namespace {

constexpr std::array<Vector<2>, 8> kSlabs2{
    {{{1, 0}}, {{0, 1}}, {{1, 1}}, {{1, -1}}, {{2, 1}}, {{1, 2}}, {{2, -1}}, {{1, -2}}}};
constexpr std::array<Vector<3>, 13> kSlabs3{{{{1, 0, 0}},
                                             {{0, 1, 0}},
                                             {{0, 0, 1}},
                                             {{1, 1, 1}},
                                             {{1, 1, -1}},
                                             {{1, -1, 1}},
                                             {{-1, 1, 1}},
                                             {{1, 1, 0}},
                                             {{1, -1, 0}},
                                             {{1, 0, 1}},
                                             {{1, 0, -1}},
                                             {{0, 1, 1}},
                                             {{0, 1, -1}}}};

using Weights2 = std::array<double, 2>;
using Weights3 = std::array<double, 3>;

double component(const Vector<2>& v, int i) { return static_cast<double>(v[i]); }
double component(const Vector<3>& v, int i) { return static_cast<double>(v[i]); }

double determinant(const std::array<Vector<2>, 2>& s) {
  return component(s[0], 0) * component(s[1], 1) - component(s[0], 1) * component(s[1], 0);
}

double determinant(const std::array<Vector<3>, 3>& s) {
  const auto minor = [&](int i, int j) {
    return component(s[1], i) * component(s[2], j) - component(s[1], j) * component(s[2], i);
  };
  return component(s[0], 0) * minor(1, 2) - component(s[0], 1) * minor(0, 2) +
         component(s[0], 2) * minor(0, 1);
}

/// Solves direction = sum of w[k] * slabs[k] by Cramer's rule; false if the slabs do not span.
template <int D>
bool solve(const std::array<Vector<D>, D>& slabs, const Vector<D>& direction,
           std::array<double, D>& weights) {
  const double whole = determinant(slabs);
  if (whole == 0) return false;
  for (std::size_t k = 0; k < D; ++k) {
    std::array<Vector<D>, D> replaced = slabs;
    replaced[k] = direction;
    weights[k] = determinant(replaced) / whole;
  }
  return true;
}

double norm(const Vector<2>& v) { return std::hypot(component(v, 0), component(v, 1)); }
double norm(const Vector<3>& v) { return std::hypot(component(v, 0), component(v, 1), component(v, 2)); }

/// Calls `visit` with each choice of D different slabs.
template <class Visit>
void for_each_choice(std::uint32_t count, std::array<std::uint32_t, 2>, Visit visit) {
  for (std::uint32_t i = 0; i < count; ++i)
    for (std::uint32_t j = i + 1; j < count; ++j) visit(std::array{i, j});
}

template <class Visit>
void for_each_choice(std::uint32_t count, std::array<std::uint32_t, 3>, Visit visit) {
  for (std::uint32_t i = 0; i < count; ++i)
    for (std::uint32_t j = i + 1; j < count; ++j)
      for (std::uint32_t k = j + 1; k < count; ++k) visit(std::array{i, j, k});
}

}  // namespace

template <>
std::span<const Vector<2>> slab_directions<2>(VolumeKind kind) {
  const std::size_t count = kind == VolumeKind::dop16 ? 8 : kind == VolumeKind::dop8 ? 4 : 2;
  return std::span(kSlabs2).first(count);
}

template <>
std::span<const Vector<3>> slab_directions<3>(VolumeKind kind) {
  const std::size_t count = kind == VolumeKind::dop26 ? 13 : kind == VolumeKind::dop14 ? 7 : 3;
  return std::span(kSlabs3).first(count);
}

template <int D>
SlabSum<D> sum_of_slabs(VolumeKind kind, const Vector<D>& direction) {
  const std::span<const Vector<D>> slabs = slab_directions<D>(kind);
  SlabSum<D> best;
  double least = std::numeric_limits<double>::infinity();
  for_each_choice(static_cast<std::uint32_t>(slabs.size()), best.slab,
                  [&](const std::array<std::uint32_t, D>& choice) {
                    std::array<Vector<D>, D> chosen;
                    for (std::size_t k = 0; k < D; ++k) chosen[k] = slabs[choice[k]];
                    std::array<double, D> weights;
                    if (!solve<D>(chosen, direction, weights)) return;
                    // The less the vectors of a sum overshoot the direction, the narrower is the bound:
                    // prefer a cone that contains it closely.
                    double overshoot = 0;
                    for (std::size_t k = 0; k < D; ++k) overshoot += std::abs(weights[k]) * norm(chosen[k]);
                    if (overshoot >= least) return;
                    least = overshoot;
                    best.slab = choice;
                    for (std::size_t k = 0; k < D; ++k) {
                      best.flip[k] = weights[k] < 0;
                      // Above 1 a product could overflow and a sum become NaN. Any non-negative weight is
                      // exact.
                      best.weight[k] = static_cast<Scalar>(std::min(std::abs(weights[k]), 1.0));
                    }
                  });
  return best;
}

template SlabSum<2> sum_of_slabs<2>(VolumeKind, const Vector<2>&);
template SlabSum<3> sum_of_slabs<3>(VolumeKind, const Vector<3>&);

}  // namespace kerf
