#include "viz/draw/draw_context.h"
#include "viz/draw/palette.h"

namespace kerf {

template <int D>
bool is_drawable(const Body<D>& body) {
  bool all = is_valid(body.box) && is_finite(body.pose.position);
  for (const Vector<D>& axis : body.pose.axes) all &= is_finite(axis);
  return all;
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
  return palette::population_color(placement.population, context.largest_population);
}

template bool is_drawable<2>(const Body<2>&);
template bool is_drawable<3>(const Body<3>&);
template Color object_color<2>(const DrawContext<2>&, std::size_t);
template Color object_color<3>(const DrawContext<3>&, std::size_t);

}  // namespace kerf
