#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/tree/tree.h"
#include "viz/draw/clip.h"

namespace kerf {

/// The drawable part of a tree, without its entries: cheap to copy, so that a frame can still show the cells
/// of nodes that have died since the one before.
template <int D>
class Skeleton {
 public:
  struct Joint {
    Plane<D> plane;
    NodeId parent;
    NodeId left;
    NodeId right;
    std::uint32_t generation = 0;
    std::uint32_t depth = 0;
    std::uint32_t population = 0;
    bool alive = false;
    [[nodiscard]] bool is_leaf() const { return left.is_none(); }
  };

  /// Takes over the nodes of `tree`; none: nothing is alive. Memory is kept from call to call.
  void assign(const Tree<D>* tree);

  /// Takes over the `root()` and `joints()` of another one.
  void assign(NodeId root, std::vector<Joint> joints);

  [[nodiscard]] NodeId root() const { return root_; }
  /// By node; undefined for nodes that are not alive.
  [[nodiscard]] std::span<const Joint> joints() const { return joints_; }
  [[nodiscard]] bool empty() const { return root_.is_none(); }
  [[nodiscard]] const Joint& operator[](NodeId id) const { return joints_[id.index()]; }
  [[nodiscard]] bool is_alive(NodeRef ref) const;
  [[nodiscard]] std::uint32_t leaves() const { return leaves_; }
  [[nodiscard]] std::uint32_t largest_leaf() const { return largest_leaf_; }

  /// The sides of the ancestors on which `id` lies: its cell, unbounded as yet. Valid until the next call.
  [[nodiscard]] std::span<const HalfSpace> cell_sides(NodeId id) const;

  /// Nodes in drawing order: a later one never lies behind an earlier one, seen from `eye`.
  [[nodiscard]] std::vector<NodeId> back_to_front(const Eigen::Vector3d& eye) const;

 private:
  void count_leaves();

  std::vector<Joint> joints_;
  NodeId root_;
  std::uint32_t leaves_ = 0;
  std::uint32_t largest_leaf_ = 0;
  mutable std::vector<HalfSpace> sides_;
};

/// The partitioner `plane` within the cell of `id`: a polygon in 3D, a segment in 2D.
template <int D>
Polygon partitioner_in_cell(const Skeleton<D>& skeleton, NodeId id, const Plane<D>& plane,
                            const Box<D>& bounds);

/// The cell of a node within `bounds`: its faces in 3D, one polygon in 2D.
template <int D>
std::vector<Polygon> cell_faces(const Skeleton<D>& skeleton, NodeId id, const Box<D>& bounds);

extern template class Skeleton<2>;
extern template class Skeleton<3>;

}  // namespace kerf
