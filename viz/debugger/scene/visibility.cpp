#include "viz/debugger/scene/visibility.h"

#include <algorithm>
#include <bit>

#include "core/tree/partitioner.h"

namespace kerf {
namespace {

constexpr double kOldest = 100;          // steps
constexpr double kMostStraddlers = 0.1;  // share of the population

double tint_value(Run& run, const TreeSnapshot& tree, NodeId leaf, Tint tint) {
  const double population = tree[leaf].population;
  // The partitioner above the leaf, whose operator made it.
  const NodeId maker = tree[leaf].parent.is_none() ? leaf : tree[leaf].parent;
  const Quality quality = tree.quality(maker);
  switch (tint) {
    case Tint::population:
      return population;
    case Tint::balance:
      return quality.population == 0 ? 1 : double{balance(quality)};
    case Tint::redundancy:
      return quality.population == 0 ? 0 : static_cast<double>(redundancy(quality)) / quality.population;
    case Tint::cost:  // pairs that a sweep of the leaf might have to test
      return 0.5 * population * population;
    case Tint::age:
      return run.position().step - run.last_change(maker);
  }
  return 0;
}

}  // namespace

template <int D>
Visibility find_visible(const Tree<D>& tree, std::size_t objects, const ViewSettings& settings) {
  Visibility visible;
  visible.nodes.assign(tree.slots(), 0);
  visible.leaf_of.assign(objects, NodeId::none());
  visible.in_several.assign(objects, 0);
  const bool all = !settings.isolated && settings.hidden_nodes.empty();
  visible.objects.assign(objects, all ? 1 : 0);
  for_each_node(tree, tree.root(), [&](NodeId id) {
    const Node<D>& node = tree[id];
    const bool above = node.parent.is_none() ? !settings.isolated : visible.nodes[node.parent.index()] != 0;
    const bool seen = (above || settings.isolated == id) && !settings.hidden_nodes.contains(id);
    visible.nodes[id.index()] = seen ? 1 : 0;
    for (const Entry& entry : node.entries) {
      const std::size_t object = entry.object.index();
      if (object >= objects) continue;
      if (seen) visible.objects[object] = 1;
      NodeId& leaf = visible.leaf_of[object];
      if (!leaf.is_none()) visible.in_several[object] = 1;
      if (leaf.is_none() || tree[leaf].population < node.population) leaf = id;
    }
  });
  for (const ObjectId object : settings.hidden_objects)
    if (object.index() < objects) visible.objects[object.index()] = 0;
  return visible;
}

float NodeTints::share(NodeId node, double colors_end) const {
  return static_cast<float>(std::clamp(double{values[node.index()]} / colors_end, 0.0, 1.0));
}

NodeTints find_tints(Run& run, Tint tint) {
  const TreeSnapshot& tree = run.tree();
  NodeTints tints{std::vector<float>(tree.nodes().size()), 1};
  double largest = 1e-9;
  for (std::uint32_t k = 0; k < tree.nodes().size(); ++k) {
    if (!tree.nodes()[k].alive || !tree.nodes()[k].is_leaf()) continue;
    tints.values[k] = static_cast<float>(tint_value(run, tree, NodeId{k}, tint));
    largest = std::max(largest, double{tints.values[k]});
  }
  if (tint == Tint::population) tints.end = std::bit_ceil(std::max(16U, static_cast<unsigned>(largest)));
  if (tint == Tint::cost) tints.end = largest;
  if (tint == Tint::redundancy) tints.end = kMostStraddlers;
  if (tint == Tint::age) tints.end = kOldest;
  return tints;
}

template Visibility find_visible<2>(const Tree<2>&, std::size_t, const ViewSettings&);
template Visibility find_visible<3>(const Tree<3>&, std::size_t, const ViewSettings&);

}  // namespace kerf
