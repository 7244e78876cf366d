#include <cstdint>

#include "viz/draw/draw_context.h"
#include "viz/draw/palette.h"

namespace kerf {

template <int D>
bool is_drawable(const Body<D>& body) {
  bool all = is_valid(body.box) && is_finite(body.pose.position);
  for (const Vector<D>& axis : body.pose.axes) all &= is_finite(axis);
  return all;
}

/// Neighbours of one colour differ a little in brightness, so that single objects stand out.
Color with_own_brightness(Color color, std::size_t object) {
  constexpr double kSpread = 0.22;
  constexpr std::uint32_t kGoldenRatio = 2654435769;  // of 2^32: its multiples fall evenly
  const std::uint32_t turn = static_cast<std::uint32_t>(object) * kGoldenRatio;
  return lit(color, 1 - kSpread * turn / 4294967296.0);
}

template <int D>
Color object_color(const DrawContext<D>& context, std::size_t object) {
  if (object < context.colors.size()) return context.colors[object];
  if (context.input.bodies[object].mobility == Mobility::fixed) return palette::kFixed;
  if (object >= context.placements.size()) return palette::kMoving;
  const Placement& placement = context.placements[object];
  if (placement.leaves > 1) return palette::kStraddler;
  // In 2D the cells themselves are tinted, and objects must stand out from them.
  if (D == 2 || placement.leaves == 0) return palette::kMoving;
  return with_own_brightness(palette::population_color(placement.population, context.largest_population),
                             object);
}

template bool is_drawable<2>(const Body<2>&);
template bool is_drawable<3>(const Body<3>&);
template Color object_color<2>(const DrawContext<2>&, std::size_t);
template Color object_color<3>(const DrawContext<3>&, std::size_t);

}  // namespace kerf
