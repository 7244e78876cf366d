#include "viz/debugger/scene/body_colors.h"

#include "viz/draw/draw_context.h"
#include "viz/draw/palette.h"

namespace kerf {

template <int D>
std::vector<Color> body_colors(std::span<const Body<D>> bodies, const Visibility& visible,
                               const NodeTints& tints, double tint_end, bool tinted) {
  std::vector<Color> colors(bodies.size());
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const NodeId leaf = visible.leaf_of[k];
    colors[k] = own_color(bodies[k].mobility, bodies[k].color);
    if (bodies[k].mobility == Mobility::fixed) continue;
    if (tinted && visible.in_several[k] != 0) {
      colors[k] = palette::kStraddler;
    } else if (D == 3 && tinted && !leaf.is_none()) {
      colors[k] = tints.color(leaf, tint_end);
    }
  }
  return colors;
}

std::vector<Color> leaf_colors(const Visibility& visible, const NodeTints& tints, double tint_end) {
  std::vector<Color> colors(visible.nodes.size(), Color{0, 0, 0, 0});
  for (std::uint32_t k = 0; k < colors.size(); ++k)
    if (visible.nodes[k] != 0) colors[k] = tints.color(NodeId{k}, tint_end);
  return colors;
}

template std::vector<Color> body_colors(std::span<const Body<2>>, const Visibility&, const NodeTints&, double,
                                        bool);
template std::vector<Color> body_colors(std::span<const Body<3>>, const Visibility&, const NodeTints&, double,
                                        bool);

}  // namespace kerf
