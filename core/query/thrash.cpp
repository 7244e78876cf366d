#include "core/query/thrash.h"

#include <algorithm>
#include <map>
#include <utility>

namespace kerf {
namespace {

using Kind = OperatorRow::Kind;

/// The last operators of a node.
struct NodeMemory {
  std::uint32_t split = 0;  ///< step of the last split; 0: none
  std::uint32_t merge = 0;  ///< step of a merge since then
  std::uint32_t shift = 0;  ///< step of the shift before the last
  std::uint32_t back = 0;   ///< step of the last shift, if it went the other way
  double way = 0;           ///< of the last shift
};

class Finder {
 public:
  explicit Finder(std::uint32_t steps) : steps_(steps) {}

  void take(const OperatorRow& row) {
    if (row.kind == Kind::scheduled) {
      listed_[key_of(row)] = row;
      return;
    }
    settle(row);
    if (row.kind != Kind::acted) return;
    if (row.op == Operator::split || row.op == Operator::shift_split) take_split(row);
    if (row.op == Operator::merge) memory_[row.node.node].merge = row.step;
    if (row.op == Operator::balance) take_shift(row);
  }

  std::vector<Thrash> finish(std::uint32_t last_step) {
    for (const auto& [key, row] : listed_) add_if_starved(row, last_step);
    std::ranges::stable_sort(found_, {}, &Thrash::event);
    return std::move(found_);
  }

 private:
  /// A shift-split that finds no point is done as a split, so both wait in one place.
  using ListKey = std::pair<std::uint64_t, Operator>;
  static ListKey key_of(const OperatorRow& row) {
    const std::uint64_t node = (std::uint64_t{row.node.generation} << 32U) | row.node.node.value;
    return {node, row.op == Operator::shift_split ? Operator::split : row.op};
  }

  void settle(const OperatorRow& row) {
    const auto listed = listed_.find(key_of(row));
    if (listed == listed_.end()) return;
    add_if_starved(listed->second, row.step);
    listed_.erase(listed);
  }

  void add_if_starved(const OperatorRow& row, std::uint32_t until) {
    // Merges are listed anew by each traversal, and done when there is time, as in the paper.
    if (row.op != Operator::merge && until - row.step > steps_)
      found_.push_back({ThrashKind::starved, row.op, row.node.node, row.event, row.step, until});
  }

  void take_split(const OperatorRow& row) {
    NodeMemory& memory = memory_[row.node.node];
    if (memory.split != 0 && memory.merge >= memory.split && row.step - memory.split <= steps_)
      found_.push_back(
          {ThrashKind::split_merge_split, row.op, row.node.node, row.event, memory.split, row.step});
    memory.split = row.step;
    memory.merge = 0;
  }

  void take_shift(const OperatorRow& row) {
    NodeMemory& memory = memory_[row.node.node];
    const bool turned = memory.way * row.shift() < 0;
    if (turned && memory.back != 0 && row.step - memory.shift <= steps_)
      found_.push_back(
          {ThrashKind::balance_ping_pong, row.op, row.node.node, row.event, memory.shift, row.step});
    memory.shift = turned && memory.back != 0 ? memory.back : turned ? memory.shift : row.step;
    memory.back = turned ? row.step : 0;
    memory.way = row.shift();
  }

  std::uint32_t steps_;
  std::map<NodeId, NodeMemory> memory_;
  std::map<ListKey, OperatorRow> listed_;
  std::vector<Thrash> found_;
};

}  // namespace

std::string_view to_string(ThrashKind kind) {
  switch (kind) {
    case ThrashKind::split_merge_split:
      return "split-merge-split";
    case ThrashKind::balance_ping_pong:
      return "balance ping-pong";
    case ThrashKind::starved:
      return "starved";
  }
  return "";
}

std::vector<Thrash> find_thrash(std::span<const OperatorRow> operators, std::uint32_t last_step,
                                std::uint32_t steps) {
  Finder finder(steps);
  for (const OperatorRow& row : operators) finder.take(row);
  return finder.finish(last_step);
}

std::string to_text(const Thrash& thrash, const GivenNames& names) {
  const std::string node = "n" + std::to_string(thrash.node.value);
  const std::string when = names.steps(thrash.first_step, thrash.last_step);
  if (thrash.kind == ThrashKind::split_merge_split)
    return node + " was split, merged and split again, " + when;
  if (thrash.kind == ThrashKind::balance_ping_pong)
    return node + " was balanced one way, back and again, " + when;
  return std::string(to_string(thrash.op)) + " of " + node + " was listed and waited, " + when;
}

}  // namespace kerf
