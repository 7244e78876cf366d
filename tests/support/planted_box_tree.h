#pragma once

#include <algorithm>
#include <vector>

#include "core/broad_phase/tabled.h"
#include "core/objects/structure.h"

namespace kerf::test {

/// Bugs that a tree of boxes can have.
enum class TreeBug : std::uint8_t { none, refit_forgotten, not_reinserted, no_margin, child_of_two };

/// A small tree of boxes as Bullet's btDbvt and Box2D's are: one fat leaf an object, which is taken out and
/// put in again when its object leaves it; boxes of the nodes above are refitted.
class PlantedBoxTree final : public SelfDescribing<2> {
 public:
  static constexpr Scalar kMargin = 0.25F;

  explicit PlantedBoxTree(TreeBug bug = TreeBug::none) : bug_(bug) {}

  void insert(ObjectId object, const Box<2>& box) {
    const auto leaf = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({fat(box), kNoPart, kNoPart, kNoPart, object});
    place(leaf);
  }

  void move(ObjectId object, const Box<2>& box) {
    const auto found = std::ranges::find(nodes_, object, &Node::object);
    const auto leaf = static_cast<std::uint32_t>(found - nodes_.begin());
    if (contains(found->box, box)) return;
    nodes_[leaf].box = fat(box);
    if (bug_ == TreeBug::refit_forgotten) return;
    take_out(leaf);
    if (bug_ != TreeBug::not_reinserted) place(leaf);
  }

  void describe(StructureParts<2>& parts) const override {
    parts.kind = "tree of boxes";
    if (root_ != kNoPart) tell(root_, kNoPart, 0, parts);
  }

 private:
  struct Node {
    Box<2> box;
    std::uint32_t parent = kNoPart;
    std::uint32_t left = kNoPart;  ///< of a leaf none
    std::uint32_t right = kNoPart;
    ObjectId object;
  };

  [[nodiscard]] Box<2> fat(const Box<2>& box) const {
    const Scalar margin = bug_ == TreeBug::no_margin ? 0 : kMargin;
    return {{{box.min[0] - margin, box.min[1] - margin}}, {{box.max[0] + margin, box.max[1] + margin}}};
  }

  /// Beside the leaf whose box grows least along its sides.
  void place(std::uint32_t leaf) {
    if (root_ == kNoPart) {
      root_ = leaf;
      return;
    }
    std::uint32_t beside = root_;
    while (nodes_[beside].left != kNoPart) {
      const auto growth = [&](std::uint32_t node) {
        const Vector<2> size = join(nodes_[node].box, nodes_[leaf].box).extent();
        const Vector<2> before = nodes_[node].box.extent();
        return size[0] + size[1] - before[0] - before[1];
      };
      beside = growth(nodes_[beside].left) <= growth(nodes_[beside].right) ? nodes_[beside].left
                                                                           : nodes_[beside].right;
    }
    const std::uint32_t above = nodes_[beside].parent;
    const auto joint = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({{}, above, beside, bug_ == TreeBug::child_of_two ? beside : leaf, {}});
    nodes_[beside].parent = nodes_[leaf].parent = joint;
    replace(above, beside, joint);
    refit(joint);
  }

  void take_out(std::uint32_t leaf) {
    const std::uint32_t joint = nodes_[leaf].parent;
    if (joint == kNoPart) {
      root_ = kNoPart;
      return;
    }
    const std::uint32_t sibling = nodes_[joint].left == leaf ? nodes_[joint].right : nodes_[joint].left;
    const std::uint32_t above = nodes_[joint].parent;
    nodes_[sibling].parent = above;
    nodes_[leaf].parent = kNoPart;
    replace(above, joint, sibling);
    refit(above);
  }

  void replace(std::uint32_t parent, std::uint32_t child, std::uint32_t with) {
    if (parent == kNoPart) {
      root_ = with;
    } else if (nodes_[parent].left == child) {
      nodes_[parent].left = with;
    } else {
      nodes_[parent].right = with;
    }
  }

  void refit(std::uint32_t node) {
    for (; node != kNoPart; node = nodes_[node].parent)
      nodes_[node].box = join(nodes_[nodes_[node].left].box, nodes_[nodes_[node].right].box);
  }

  void tell(std::uint32_t node, std::uint32_t parent, std::uint32_t depth, StructureParts<2>& parts) const {
    const auto cell = static_cast<std::uint32_t>(parts.cells.size());
    parts.cells.push_back({nodes_[node].box, node, parent, depth, kNoPart});
    if (nodes_[node].left == kNoPart) {
      parts.members.push_back({cell, nodes_[node].object});
      return;
    }
    tell(nodes_[node].left, cell, depth + 1, parts);
    tell(nodes_[node].right, cell, depth + 1, parts);
  }

  TreeBug bug_;
  std::vector<Node> nodes_;
  std::uint32_t root_ = kNoPart;
};

}  // namespace kerf::test
