#include "viz/debugger/model/object_figures.h"

#include <utility>

namespace kerf {

template <int D>
std::vector<ObjectFigures> find_object_figures(const BspState<D>& state) {
  const ObjectTable<D>& table = state.latest;
  std::vector<std::uint32_t> leaves(table.bound(), 0);
  std::vector<std::uint32_t> pairs(table.bound(), 0);
  for_each_node(state.tree, state.tree.root(), [&](NodeId id) {
    if (!state.tree[id].is_leaf()) return;
    for (const Entry& entry : state.tree[id].entries)
      if (entry.object.index() < leaves.size()) ++leaves[entry.object.index()];
  });
  for (const Pair& pair : state.pairs)
    for (const ObjectId object : {pair.a, pair.b})
      if (object.index() < pairs.size()) ++pairs[object.index()];

  std::vector<ObjectFigures> figures;
  for_each_placed(table, [&](ObjectId object) {
    const std::size_t k = object.index();
    ObjectFigures of{object, table.is_fixed(object), leaves[k], pairs[k], {}, {}};
    const Box<D> box = table.box(object);
    for (int axis = 0; axis < D; ++axis) {
      of.centre.push_back((double{box.min[axis]} + double{box.max[axis]}) / 2);
      of.size.push_back(double{box.max[axis]} - double{box.min[axis]});
    }
    figures.push_back(std::move(of));
  });
  return figures;
}

template std::vector<ObjectFigures> find_object_figures<2>(const BspState<2>&);
template std::vector<ObjectFigures> find_object_figures<3>(const BspState<3>&);

}  // namespace kerf
