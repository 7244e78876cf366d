#pragma once

#include <cstdint>
#include <vector>

#include "core/tree/tree.h"

namespace kerf {

/// Values derived from the leaves of a tree, by node. Each cache remembers the node's life and the
/// version of its entries that a value belongs to, so that several caches can follow one tree and none of
/// them hides a change from another. Different leaves can be read and written at the same time.
template <int D, class Value>
class LeafCache {
 public:
  /// Forgets all values and gives their memory back.
  void clear() { slots_.clear(); }
  /// Forgets all values; their memory stays for others.
  void forget() {
    for (Slot& slot : slots_) slot.life = 0;
  }
  /// There is a value for each node from now on.
  void make_room(const Tree<D>& tree) {
    if (slots_.size() < tree.slots()) slots_.resize(tree.slots());
  }
  [[nodiscard]] std::size_t size() const { return slots_.size(); }
  [[nodiscard]] Value& operator[](NodeId leaf) { return slots_[leaf.index()].value; }
  [[nodiscard]] const Value& operator[](NodeId leaf) const { return slots_[leaf.index()].value; }

  /// Whether the value is of this leaf, as it is or as it was.
  [[nodiscard]] bool has(const Tree<D>& tree, NodeId leaf) const {
    return leaf.index() < slots_.size() && slots_[leaf.index()].life == life_of(tree[leaf]);
  }
  /// Whether the value is of this leaf as it is.
  [[nodiscard]] bool is_current(const Tree<D>& tree, NodeId leaf) const {
    return has(tree, leaf) && slots_[leaf.index()].version == tree[leaf].version;
  }
  /// The value is of this leaf as it is from now on.
  void renew(const Tree<D>& tree, NodeId leaf) {
    slots_[leaf.index()].life = life_of(tree[leaf]);
    slots_[leaf.index()].version = tree[leaf].version;
  }

 private:
  struct Slot {
    std::uint32_t life = 0;  ///< of the node; 0: there is no value
    std::uint32_t version = 0;
    Value value;
  };
  static std::uint32_t life_of(const Node<D>& node) { return node.generation + 1; }

  std::vector<Slot> slots_;
};

}  // namespace kerf
