#include "viz/draw/draw_context.h"
#include "viz/draw/palette.h"

namespace kerf {

template <int D>
bool is_drawable(const Body<D>& body) {
  bool all = is_valid(body.box) && is_finite(body.pose.position);
  for (const Vector<D>& axis : body.pose.axes) all &= is_finite(axis);
  return all;
}

Color own_color(Mobility mobility, const std::optional<Rgb>& given) {
  if (given) return {given->r, given->g, given->b};
  return mobility == Mobility::fixed ? palette::kFixed : palette::kMoving;
}

template <int D>
Color object_color(const DrawContext<D>& context, std::size_t object) {
  if (object < context.colors.size()) return context.colors[object];
  const Body<D>& body = context.input.bodies[object];
  const Color own = own_color(body.mobility, body.color);
  if (body.mobility == Mobility::fixed || object >= context.placements.size()) return own;
  const Placement& placement = context.placements[object];
  if (placement.leaves > 1) return palette::kStraddler;
  // In 2D the cells themselves are tinted, and objects must stand out from them.
  if (D == 2 || placement.leaves == 0) return own;
  return palette::population_color(placement.population, context.largest_population);
}

template bool is_drawable<2>(const Body<2>&);
template bool is_drawable<3>(const Body<3>&);
template Color object_color<2>(const DrawContext<2>&, std::size_t);
template Color object_color<3>(const DrawContext<3>&, std::size_t);

}  // namespace kerf
