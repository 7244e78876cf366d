#include "viz/debugger/scene/tints.h"

#include <algorithm>
#include <bit>

#include "core/tree/partitioner.h"
#include "viz/draw/palette.h"

namespace kerf {
namespace {

constexpr double kOldest = 100;          // steps
constexpr double kMostStraddlers = 0.1;  // share of the population

/// The living nodes, children before their parents.
std::vector<NodeId> from_below(const TreeSnapshot& tree) {
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

NodeFigures figures_of_node(const TreeMoment& moment, NodeId id) {
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
  for (const NodeId id : from_below(moment.tree)) {
    NodeFigures& of = figures[id.index()];
    of = figures_of_node(moment, id);
    const TreeSnapshot::Node& node = moment.tree[id];
    if (!node.is_leaf()) of.cost = figures[node.left.index()].cost + figures[node.right.index()].cost;
  }
  return figures;
}

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
  for (const NodeId id : from_below(tree)) {
    const TreeSnapshot::Node& node = tree[id];
    float& value = tints.values[id.index()];
    if (of_leaves && !node.is_leaf()) {
      value = std::max(tints.values[node.left.index()], tints.values[node.right.index()]);
    } else {
      value = static_cast<float>(value_of(figures_of_node(moment, id), tint));
    }
    largest = std::max(largest, double{value});
  }
  tints.end = end_of_colors(tint, largest);
  return tints;
}

}  // namespace kerf
