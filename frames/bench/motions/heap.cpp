#include "frames/bench/motions/heap.h"

namespace kerf {
namespace {

constexpr float kSteepest = 1.5F;  ///< of a usual extent from cell to cell

}  // namespace

Heap::Heap(std::uint32_t width, int horizontal) : width_(width), horizontal_(horizontal) {
  const std::size_t cells = horizontal == 1 ? width : static_cast<std::size_t>(width) * width;
  heights_.resize(cells);
  walls_.resize(cells);
  stacks_.resize(cells);
}

Heap::Cell Heap::random_cell(Random& random) const {
  for (;;) {
    const Cell cell = random.below(cells());
    if (!is_wall(cell)) return cell;
  }
}

std::optional<Heap::Cell> Heap::neighbour(Cell cell, int direction) const {
  const int axis = direction / 2;
  const bool up = direction % 2 == 1;
  const std::uint32_t along = coordinate(cell, axis);
  if (up ? along + 1 == width_ : along == 0) return std::nullopt;
  const Cell stride = axis == 0 ? 1 : width_;
  const Cell there = up ? cell + stride : cell - stride;
  return is_wall(there) ? std::nullopt : std::optional(there);
}

std::optional<Heap::Cell> Heap::downhill(Cell cell) const {
  std::optional<Cell> lowest;
  float least = height(cell) - kSteepest;
  for (int direction = 0; direction < 2 * horizontal_; ++direction) {
    const auto there = neighbour(cell, direction);
    if (!there || height(*there) >= least) continue;
    least = height(*there);
    lowest = there;
  }
  return lowest;
}

std::optional<Heap::Cell> Heap::sideways(Cell cell, Random& random) const {
  const auto there =
      neighbour(cell, static_cast<int>(random.below(static_cast<std::uint32_t>(2 * horizontal_))));
  return there && height(*there) <= height(cell) ? there : std::nullopt;
}

void Heap::put(Cell cell, std::uint32_t object, float thickness) {
  stacks_[cell].push_back({object, thickness});
  heights_[cell] += thickness;
}

std::optional<std::uint32_t> Heap::take(Cell cell) {
  if (stacks_[cell].empty()) return std::nullopt;
  const Layer top = stacks_[cell].back();
  stacks_[cell].pop_back();
  heights_[cell] = stacks_[cell].empty() ? 0 : heights_[cell] - top.thickness;
  return top.object;
}

}  // namespace kerf
