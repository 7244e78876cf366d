#include "core/recording/look.h"

#include <cmath>

#include "core/scene/shape_kind.h"

namespace kerf {
namespace {

constexpr Scalar kWholeStretch = 512;
constexpr Scalar kLeastRatio = 0.6F;
constexpr Scalar kMostRatio = 1.6F;

}  // namespace

template <int D>
Shape<D> stretched(const Shape<D>& shape, const Stretch<D>& stretch) {
  const auto* const brick = brick_of<D>(shape);
  if (brick == nullptr || stretch == Stretch<D>{}) return shape;
  Brick<D> result = *brick;
  for (std::size_t i = 0; i < D; ++i)
    result.half.value[i] *= 1 + static_cast<Scalar>(stretch[i]) / kWholeStretch;
  return result;
}

template <int D>
std::optional<Stretch<D>> stretch_between(const Shape<D>& base, const Shape<D>& shape) {
  const auto* const from = brick_of<D>(base);
  const auto* const to = brick_of<D>(shape);
  if (from == nullptr || to == nullptr) return std::nullopt;
  Stretch<D> stretch{};
  for (std::size_t i = 0; i < D; ++i) {
    const Scalar ratio = to->half.value[i] / from->half.value[i];
    if (!(ratio >= kLeastRatio && ratio <= kMostRatio)) return std::nullopt;
    stretch[i] = static_cast<std::int16_t>(std::lround((ratio - 1) * kWholeStretch));
  }
  return stretch;
}

template Shape<2> stretched<2>(const Shape<2>&, const Stretch<2>&);
template Shape<3> stretched<3>(const Shape<3>&, const Stretch<3>&);
template std::optional<Stretch<2>> stretch_between<2>(const Shape<2>&, const Shape<2>&);
template std::optional<Stretch<3>> stretch_between<3>(const Shape<3>&, const Shape<3>&);

}  // namespace kerf
