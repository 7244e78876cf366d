#include "tests/support/crowd_shapes.h"

#include <algorithm>
#include <cmath>

#include "core/scene/shape_kind.h"
#include "tests/support/recorded_crowd.h"

namespace kerf::test {

template <>
std::array<Vector<2>, 2> turned_axes<2>(double angle) {
  const auto c = static_cast<Scalar>(std::cos(angle));
  const auto s = static_cast<Scalar>(std::sin(angle));
  return {Vector<2>{{c, s}}, Vector<2>{{-s, c}}};
}

/// About (1, 2, 2) / 3.
template <>
std::array<Vector<3>, 3> turned_axes<3>(double angle) {
  constexpr std::array<double, 3> kAxis{1.0 / 3, 2.0 / 3, 2.0 / 3};
  std::array<Vector<3>, 3> axes;
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < 3; ++i) {
      const double across = k == i ? 0 : kAxis[3 - k - i] * ((k + 1) % 3 == i ? 1 : -1);
      axes[k].value[i] = static_cast<Scalar>(kAxis[k] * kAxis[i] * (1 - std::cos(angle)) +
                                             (k == i ? std::cos(angle) : 0) + across * std::sin(angle));
    }
  return axes;
}

template <>
std::vector<Shape<2>> all_shapes<2>(Scalar radius) {
  const Scalar half = radius * 0.5F;
  return {Ball{radius}, Brick<2>{{{radius * 0.75F, half}}},
          Outline{{{{-half, -half}}, {{radius, 0}}, {{0, half}}}}};
}

template <>
std::vector<Shape<3>> all_shapes<3>(Scalar radius) {
  const Scalar half = radius * 0.5F;
  return {
      Ball{radius}, Brick<3>{{{radius * 0.75F, half, half * 0.5F}}},
      std::make_shared<const Surface>(Surface{{{{0, 0, 0}}, {{radius, 0, 0}}, {{0, half, 0}}, {{0, 0, half}}},
                                              {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}})};
}

template <int D>
Appearance<D> CrowdShapes<D>::appearance(ObjectId object) {
  if (!tree_.objects().is_placed(object)) return {};
  const Vector<D> extent = tree_.objects().box(object).extent();
  const Scalar least = *std::ranges::min_element(extent.value);
  if (!(least > 0)) return {};
  const int size = std::ilogb(least) - 1;
  const std::uint32_t kind = object.value % 3;
  const auto [found, is_new] = shapes_.try_emplace({kind, size});
  if (is_new) found->second = all_shapes<D>(std::ldexp(1.0F, size)).at(kind);
  const double angle = 0.7 * object.value + 0.05 * (object.value % 5) * tree_.steps();
  const Turn<D> turn = turn_of<D>(turned_axes<D>(angle));
  const auto* const brick = brick_of<D>(found->second);
  if (brick == nullptr) return {&found->second, turn, std::nullopt};
  Brick<D> now = *brick;
  now.half[1] *= static_cast<Scalar>(1 + 0.15 * std::sin(0.4 * tree_.steps() + object.value));
  Shape<D>& breathing = breathing_[object] = now;
  return {&breathing, turn, std::nullopt};
}

template <int D>
void record_shaped_crowd(const std::filesystem::path& path, std::uint32_t steps) {
  Bsp<D, EventLog> tree(busy_config());
  Recorder<D> recorder(tree, path, info_of<D>(tree.config()));
  CrowdShapes<D> shapes(tree);
  recorder.show([&](ObjectId object) { return shapes.appearance(object); });
  play_crowd<D>(recorder, steps, 1, [&](std::uint32_t /*step*/) { (void)tree.trace().take(); });
  recorder.finish();
}

template void record_shaped_crowd<2>(const std::filesystem::path&, std::uint32_t);
template void record_shaped_crowd<3>(const std::filesystem::path&, std::uint32_t);
template class CrowdShapes<2>;
template class CrowdShapes<3>;

}  // namespace kerf::test
