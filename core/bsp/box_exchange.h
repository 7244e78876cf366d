#pragma once

#include <cstring>
#include <span>
#include <utility>

#include "core/base/append_buffer.h"
#include "core/objects/object_table.h"

namespace kerf {

/// A step in which everybody moved need not copy the latest boxes into the tree's table: the two tables
/// exchange theirs. From then on, until the next requests, the latest boxes are the tree's; those that took
/// their place are of the step before. Mostly the same objects move again and write over them. Only boxes are
/// exchanged: who is there, in quarantine or fixed may be asked of the latest table all the while.
template <int D>
class BoxExchange {
 public:
  /// The tables differ in nothing but the boxes of those that moved.
  void begin(ObjectTable<D>& latest, ObjectTable<D>& tree) {
    latest.swap_boxes(tree);
    is_open_ = true;
  }
  /// Takes the list of who moved in the step, and gives an empty one.
  void take(AppendBuffer<ObjectId>& moved) {
    std::swap(moved_, moved);
    moved.clear();
  }
  /// To be told before anyone writes the latest boxes, or reads them there, with those that are about to be
  /// moved and must be.
  void end(ObjectTable<D>& latest, const ObjectTable<D>& tree, std::span<const ObjectId> moving,
           TaskPool& pool) {
    if (!is_open_) return;
    is_open_ = false;
    if (!are_those_that_moved(moving)) latest.copy_boxes(tree, pool);
  }
  /// The latest table was replaced.
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
