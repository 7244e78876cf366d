#include "viz/debugger/model/node_figures.h"

#include <algorithm>

#include "core/tree/partitioner.h"

namespace kerf {

std::vector<NodeId> children_first(const TreeSnapshot& tree) {
  std::vector<NodeId> order;
  if (tree.empty()) return order;
  order.push_back(tree.root());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const TreeSnapshot::Node node = tree[order[k]];
    if (!node.is_leaf()) order.insert(order.end(), {node.left, node.right});
  }
  std::ranges::reverse(order);
  return order;
}

NodeFigures figures_of(const TreeMoment& moment, NodeId id) {
  const TreeSnapshot::Node& node = moment.tree[id];
  // The partitioner above a leaf, whose operator made it.
  const NodeId maker = node.is_leaf() && !node.parent.is_none() ? node.parent : id;
  const Quality quality = moment.tree.quality(maker);
  NodeFigures figures;
  figures.population = node.population;
  if (quality.population > 0) {
    figures.balance = double{balance(quality)};
    figures.redundancy = static_cast<double>(redundancy(quality)) / quality.population;
  }
  figures.cost = node.is_leaf() ? 0.5 * figures.population * figures.population : 0;
  if (maker.index() < moment.last_changes.size())
    figures.age = moment.step - moment.last_changes[maker.index()];
  return figures;
}

std::vector<std::uint32_t> last_changes(std::span<const OperatorRow> operators, const Position& moment,
                                        std::size_t slots) {
  std::vector<std::uint32_t> last(slots, 0);
  for (const OperatorRow& row : operators) {
    if (row.step > moment.step || row.event > moment.event) break;
    if (row.kind == OperatorRow::Kind::acted && row.node.node.index() < slots)
      last[row.node.node.index()] = row.step;
  }
  return last;
}

std::vector<NodeFigures> find_figures(const TreeMoment& moment) {
  std::vector<NodeFigures> figures(moment.tree.nodes().size());
  for (const NodeId id : children_first(moment.tree)) {
    NodeFigures& of = figures[id.index()];
    of = figures_of(moment, id);
    const TreeSnapshot::Node& node = moment.tree[id];
    if (!node.is_leaf()) of.cost = figures[node.left.index()].cost + figures[node.right.index()].cost;
  }
  return figures;
}

}  // namespace kerf
