#include "core/query/node_lives.h"

#include <stdexcept>
#include <string>

namespace kerf {
namespace {

/// The links of the tree without its content. Slots are reused as Tree does: the last freed first.
class Lineage {
 public:
  Lineage() { root_ = make(NodeId::none(), {}); }

  void play(const OperatorRow& row) {
    check(row);
    switch (row.op) {
      case Operator::split:
      case Operator::shift_split:
        return divide(row);
      case Operator::merge:
        return merge(row);
      case Operator::swap:
        return swap(row);
      case Operator::balance:
        return;
    }
  }
  std::vector<std::vector<NodeLife>> take() { return std::move(lives_); }

 private:
  struct Links {
    NodeId parent;
    NodeId left;
    NodeId right;
    bool alive = false;
  };

  Links& at(NodeId id) { return nodes_[id.index()]; }
  NodeLife& life(NodeId id) { return lives_[id.index()].back(); }

  void check(const OperatorRow& row) {
    const NodeRef ref = row.node;
    const bool lives =
        ref.node.index() < nodes_.size() && at(ref.node).alive && life(ref.node).generation == ref.generation;
    const bool divides = row.op == Operator::split || row.op == Operator::shift_split;
    if (lives && at(ref.node).left.is_none() == divides) return;
    throw std::runtime_error("the recording is damaged: e" + std::to_string(row.event) + " cannot be at n" +
                             std::to_string(ref.node.value));
  }

  NodeId make(NodeId parent, const OperatorRow& row) {
    NodeId id{static_cast<std::uint32_t>(nodes_.size())};
    if (free_.empty()) {
      nodes_.emplace_back();
      lives_.emplace_back();
    } else {
      id = free_.back();
      free_.pop_back();
    }
    at(id) = {parent, NodeId::none(), NodeId::none(), true};
    const auto generation = static_cast<std::uint32_t>(lives_[id.index()].size());
    lives_[id.index()].push_back({generation, begin(row), {}});
    return id;
  }

  void divide(const OperatorRow& row) {
    const NodeId id = row.node.node;
    const NodeId left = make(id, row);
    const NodeId right = make(id, row);
    at(id).left = left;
    at(id).right = right;
    life(id).divided.push_back(begin(row));
  }

  void merge(const OperatorRow& row) {
    const NodeId id = row.node.node;
    release_below(at(id).left, row);
    release_below(at(id).right, row);
    at(id).left = at(id).right = NodeId::none();
    end(life(id).divided.back(), row);
  }

  /// The lighter child dies with everything below it, the heavier one takes the place of its parent.
  void swap(const OperatorRow& row) {
    const Links inner = at(row.node.node);
    const bool left_heavy = row.before.left >= row.before.right;
    const NodeId heavy = left_heavy ? inner.left : inner.right;
    release_below(left_heavy ? inner.right : inner.left, row);
    at(heavy).parent = inner.parent;
    if (inner.parent.is_none()) {
      root_ = heavy;
    } else {
      Links& above = at(inner.parent);
      (above.left == row.node.node ? above.left : above.right) = heavy;
    }
    release(row.node.node, row);
  }

  void release_below(NodeId top, const OperatorRow& row) {
    std::vector<NodeId> todo{top};
    while (!todo.empty()) {
      const NodeId id = todo.back();
      todo.pop_back();
      const Links links = at(id);
      release(id, row);
      if (links.left.is_none()) continue;
      todo.push_back(links.right);
      todo.push_back(links.left);
    }
  }

  void release(NodeId id, const OperatorRow& row) {
    if (!at(id).left.is_none()) end(life(id).divided.back(), row);
    end(life(id).span, row);
    at(id) = {};
    free_.push_back(id);
  }

  static LifeSpan begin(const OperatorRow& row) { return {row.step, row.event, std::nullopt, 0}; }
  static void end(LifeSpan& span, const OperatorRow& row) {
    span.last_step = row.step;
    span.last_event = row.event;
  }

  std::vector<Links> nodes_;
  std::vector<NodeId> free_;
  NodeId root_;
  std::vector<std::vector<NodeLife>> lives_;
};

}  // namespace

std::vector<std::vector<NodeLife>> find_node_lives(std::span<const OperatorRow> operators) {
  Lineage lineage;
  for (const OperatorRow& row : operators)
    if (row.kind == OperatorRow::Kind::acted) lineage.play(row);
  return lineage.take();
}

}  // namespace kerf
