#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/trace/event.h"
#include "core/tree/tree.h"

namespace kerf {

/// The nodes of a tree at a moment, without their entries: what outlines, colours and pictures need of it,
/// and cheap to copy, so that a picture can still show nodes that have died since.
class TreeSnapshot {
 public:
  struct Node {
    NodeId parent;
    NodeId left;  ///< none: a leaf
    NodeId right;
    std::uint32_t generation = 0;
    std::uint32_t depth = 0;
    std::uint32_t population = 0;
    bool alive = false;
    [[nodiscard]] bool is_leaf() const { return left.is_none(); }
  };

  [[nodiscard]] NodeId root() const { return root_; }
  [[nodiscard]] bool empty() const { return root_.is_none(); }
  /// By node; those that are not alive mean nothing.
  [[nodiscard]] std::span<const Node> nodes() const { return nodes_; }
  [[nodiscard]] const Node& operator[](NodeId id) const { return nodes_[id.index()]; }
  [[nodiscard]] bool is_alive(NodeId id) const { return id.index() < nodes_.size() && (*this)[id].alive; }
  [[nodiscard]] bool is_alive(NodeRef ref) const {
    return is_alive(ref.node) && (*this)[ref.node].generation == ref.generation;
  }
  /// Of an inner node's partitioner; empty for a leaf.
  [[nodiscard]] Quality quality(NodeId id) const;
  [[nodiscard]] std::uint32_t leaves() const { return leaves_; }
  [[nodiscard]] std::uint32_t largest_leaf() const { return largest_leaf_; }

 protected:
  void count_leaves();

  NodeId root_;
  std::vector<Node> nodes_;

 private:
  std::uint32_t leaves_ = 0;
  std::uint32_t largest_leaf_ = 0;
};

/// The same with the partitioners.
template <int D>
class TreeSnapshotOf final : public TreeSnapshot {
 public:
  /// Takes over the nodes of `tree`; none: nothing is alive. Memory is kept from call to call.
  void assign(const Tree<D>* tree);
  /// Takes over what `root()`, `nodes()` and `planes()` of another one gave.
  void assign(NodeId root, std::vector<Node> nodes, std::vector<Plane<D>> planes);

  /// By node; those of leaves mean nothing.
  [[nodiscard]] std::span<const Plane<D>> planes() const { return planes_; }
  [[nodiscard]] const Plane<D>& plane(NodeId inner) const { return planes_[inner.index()]; }

 private:
  std::vector<Plane<D>> planes_;
};

}  // namespace kerf
