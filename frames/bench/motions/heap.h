#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/random.h"

namespace kerf {

/// A floor of square cells, each with a stack of objects: a cheap model of sand. A cell may be a wall, on
/// which nothing comes to rest. Cells are along the horizontal axes: one in 2D, two in 3D.
class Heap {
 public:
  using Cell = std::uint32_t;

  /// `width` cells along each of the `horizontal` axes.
  Heap(std::uint32_t width, int horizontal);

  [[nodiscard]] std::uint32_t width() const { return width_; }
  [[nodiscard]] Cell cells() const { return static_cast<Cell>(heights_.size()); }
  /// The place of a cell along one axis.
  [[nodiscard]] std::uint32_t coordinate(Cell cell, int axis) const {
    return axis == 0 ? cell % width_ : cell / width_;
  }
  void make_wall(Cell cell) { walls_[cell] = 1; }
  [[nodiscard]] bool is_wall(Cell cell) const { return walls_[cell] != 0; }
  [[nodiscard]] Cell random_cell(Random& random) const;
  [[nodiscard]] float height(Cell cell) const { return heights_[cell]; }

  /// The lowest neighbour of a cell if the way there is steeper than sand allows.
  [[nodiscard]] std::optional<Cell> downhill(Cell cell) const;
  /// A random neighbour, unless it is a wall or higher.
  [[nodiscard]] std::optional<Cell> sideways(Cell cell, Random& random) const;

  /// Puts an object of that thickness on top of a cell.
  void put(Cell cell, std::uint32_t object, float thickness);
  /// Takes the topmost object off a cell, if there is one.
  std::optional<std::uint32_t> take(Cell cell);

 private:
  struct Layer {
    std::uint32_t object;
    float thickness;
  };
  /// The neighbour in direction 0 to 2 * horizontal - 1, unless it is a wall or outside.
  [[nodiscard]] std::optional<Cell> neighbour(Cell cell, int direction) const;

  std::uint32_t width_;
  int horizontal_;
  std::vector<float> heights_;
  std::vector<std::uint8_t> walls_;
  std::vector<std::vector<Layer>> stacks_;
};

}  // namespace kerf
