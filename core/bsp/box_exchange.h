#pragma once

#include <cstring>
#include <span>
#include <utility>

#include "core/base/append_buffer.h"
#include "core/objects/object_table.h"

namespace kerf {

/// A step in which all objects moved need not copy the latest boxes into the tree's table: the two tables
/// exchange their boxes. From then on, until the next requests, the tree's table has the latest boxes, and
/// the other one those of the step before. Mostly the same objects move again and overwrite them. Only
/// boxes are exchanged: either table always shows which objects are present, in quarantine or fixed.
template <int D>
class BoxExchange {
 public:
  /// The tables differ in nothing but the boxes of those that moved.
  void begin(ObjectTable<D>& latest, ObjectTable<D>& tree) {
    latest.swap_boxes(tree);
    is_open_ = true;
  }
  /// Takes the list of objects that moved in the step, and leaves an empty one.
  void take(AppendBuffer<ObjectId>& moved) {
    std::swap(moved_, moved);
    moved.clear();
  }
  /// Call it before the latest boxes are written, or read in the latest table. `moving`: the objects that are
  /// about to be moved.
  void end(ObjectTable<D>& latest, const ObjectTable<D>& tree, std::span<const ObjectId> moving,
           TaskPool& pool) {
    if (!is_open_) return;
    is_open_ = false;
    if (!are_those_that_moved(moving)) latest.copy_boxes(tree, pool);
  }
  /// Call it when the latest table was replaced.
  void forget() { is_open_ = false; }
  [[nodiscard]] bool is_open() const { return is_open_; }

 private:
  [[nodiscard]] bool are_those_that_moved(std::span<const ObjectId> moving) const {
    return moving.size() == moved_.size() &&
           std::memcmp(moving.data(), moved_.all().data(), moving.size_bytes()) == 0;
  }

  AppendBuffer<ObjectId> moved_;
  bool is_open_ = false;
};

}  // namespace kerf
