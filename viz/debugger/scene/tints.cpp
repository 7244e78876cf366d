#include "viz/debugger/scene/tints.h"

#include <algorithm>
#include <bit>

#include "viz/draw/palette.h"

namespace kerf {
namespace {

constexpr double kOldest = 100;          // steps
constexpr double kMostStraddlers = 0.1;  // share of the population

double value_of(const NodeFigures& figures, Tint tint) {
  switch (tint) {
    case Tint::population:
      return figures.population;
    case Tint::balance:
      return figures.balance;
    case Tint::redundancy:
      return figures.redundancy;
    case Tint::cost:
      return figures.cost;
    case Tint::age:
      return figures.age;
  }
  return 0;
}

double end_of_colors(Tint tint, double largest) {
  if (tint == Tint::population) return std::bit_ceil(std::max(16U, static_cast<unsigned>(largest)));
  if (tint == Tint::cost) return largest;
  if (tint == Tint::redundancy) return kMostStraddlers;
  return tint == Tint::age ? kOldest : 1;
}

}  // namespace

float NodeTints::share(NodeId node, double colors_end) const {
  return static_cast<float>(std::clamp(double{values[node.index()]} / colors_end, 0.0, 1.0));
}

Color NodeTints::color(NodeId node, double colors_end) const {
  return palette::population_color(static_cast<std::uint32_t>(share(node, colors_end) * 1000), 1000);
}

NodeTints find_tints(const TreeMoment& moment, Tint tint) {
  const TreeSnapshot& tree = moment.tree;
  NodeTints tints{std::vector<float>(tree.nodes().size()), 1};
  const bool of_leaves = tint == Tint::population || tint == Tint::cost;
  double largest = 1e-9;
  for (const NodeId id : children_first(tree)) {
    const TreeSnapshot::Node& node = tree[id];
    float& value = tints.values[id.index()];
    if (of_leaves && !node.is_leaf()) {
      value = std::max(tints.values[node.left.index()], tints.values[node.right.index()]);
    } else {
      value = static_cast<float>(value_of(figures_of(moment, id), tint));
    }
    largest = std::max(largest, double{value});
  }
  tints.end = end_of_colors(tint, largest);
  return tints;
}

}  // namespace kerf
