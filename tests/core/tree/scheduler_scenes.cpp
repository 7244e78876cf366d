#include "tests/core/tree/scheduler_scenes.h"

namespace kerf::test {
namespace {

constexpr Scalar kCellWidth = 20;

/// A unit box at (x, y), within one cell; along a third axis all boxes coincide.
template <int D>
Box<D> unit_at(Scalar x, Scalar y) {
  Box<D> box = slab<D>(x, x + 1);
  box.min[1] = y;
  box.max[1] = y + 1;
  return box;
}

template <int D>
void fill(Cell cell, Scalar left, std::vector<Box<D>>& boxes) {
  const auto along = [&](int count, Scalar dx, Scalar dy) {
    for (int k = 0; k < count; ++k)
      boxes.push_back(unit_at<D>(left + 1 + static_cast<Scalar>(k) * dx, static_cast<Scalar>(k) * dy));
  };
  if (cell == Cell::calm) along(4, 2, 0);
  if (cell == Cell::thin) along(2, 2, 0);
  if (cell == Cell::shifting || cell == Cell::shiftable) along(7, 2, 0);
  if (cell == Cell::crowded) along(7, 0, 2);
  if (cell == Cell::stuck || cell == Cell::lump) along(7, 0, 0);
}

/// Parts the cells from `first` on, `count` of them, that lie in this leaf.
template <int D>
void part(SchedulerScene<D>& scene, const std::vector<Cell>& cells, NodeId leaf, std::size_t first,
          std::size_t count) {
  if (count > 1) {
    const std::size_t half = count / 2;
    plant(scene.tree, leaf, 0, kCellWidth * static_cast<Scalar>(first + half));
    part(scene, cells, scene.tree[leaf].left, first, half);
    part(scene, cells, scene.tree[leaf].right, first + half, count - half);
    return;
  }
  scene.node[first] = leaf;
  const Scalar left = kCellWidth * static_cast<Scalar>(first);
  if (cells[first] == Cell::thin) plant(scene.tree, leaf, 0, left + 2.5F);
  if (cells[first] == Cell::stuck || cells[first] == Cell::shiftable) plant(scene.tree, leaf, 0, left + 19);
}

}  // namespace

template <int D>
SchedulerScene<D> scene_of(const std::vector<Cell>& cells) {
  std::vector<Box<D>> boxes;
  for (std::size_t i = 0; i < cells.size(); ++i)
    fill<D>(cells[i], kCellWidth * static_cast<Scalar>(i), boxes);
  SchedulerScene<D> scene{tree_of<D>(boxes), std::vector<NodeId>(cells.size())};
  part(scene, cells, scene.tree.root(), 0, cells.size());
  return scene;
}

std::vector<std::string> reported(Reporter<EventLog>& reporter) {
  std::vector<std::string> lines;
  for (const Event& event : reporter.trace().take()) {
    const std::string line = describe(event, {});
    const std::string prefix = "e" + std::to_string(event.id) + " step " + std::to_string(event.step) + " ";
    lines.push_back(line.substr(prefix.size()));
  }
  return lines;
}

std::string scheduled(Operator op, NodeId node) {
  return std::string(to_string(op)) + " n" + std::to_string(node.value) + " scheduled";
}

std::string refused(Operator op, NodeId node, Refusal reason) {
  return std::string(to_string(op)) + " n" + std::to_string(node.value) +
         " refused: " + std::string(to_string(reason));
}

std::string acted(Operator op, NodeId node, const std::string& before, const std::string& after) {
  return std::string(to_string(op)) + " n" + std::to_string(node.value) + ": " + before + " -> " + after;
}

template SchedulerScene<2> scene_of<2>(const std::vector<Cell>&);
template SchedulerScene<3> scene_of<3>(const std::vector<Cell>&);

}  // namespace kerf::test
