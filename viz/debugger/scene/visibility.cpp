#include "viz/debugger/scene/visibility.h"

namespace kerf {

template <int D>
Visibility find_visible(const Tree<D>& tree, std::size_t objects, const ViewSettings& settings) {
  Visibility visible;
  visible.nodes.assign(tree.slots(), 0);
  visible.leaf_of.assign(objects, NodeId::none());
  visible.in_several.assign(objects, 0);
  const auto& wanted = settings.isolated;
  const bool isolated = wanted && wanted->index() < tree.slots() && tree[*wanted].alive;
  visible.lacks_isolated = wanted && !isolated;
  const bool all = !isolated && settings.hidden_nodes.empty();
  visible.objects.assign(objects, all ? 1 : 0);
  for_each_node(tree, tree.root(), [&](NodeId id) {
    const Node<D>& node = tree[id];
    const bool above = node.parent.is_none() ? !isolated : visible.nodes[node.parent.index()] != 0;
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

template Visibility find_visible<2>(const Tree<2>&, std::size_t, const ViewSettings&);
template Visibility find_visible<3>(const Tree<3>&, std::size_t, const ViewSettings&);

bool is_sampled(std::size_t object, double share) {
  const auto mixed = static_cast<std::uint32_t>(object * 2654435769U);
  return static_cast<double>(mixed) < share * 4294967296.0;
}

}  // namespace kerf
