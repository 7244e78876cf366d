#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/config.h"
#include "core/trace/reporter.h"
#include "core/tree/tree.h"

namespace kerf {

/// Algorithm 1 of the paper (section 5.2): decides which operators the tree needs and applies a few of them
/// in each step.
///
/// `traverse` walks from the root. An unbalanced node is balanced at once or, if no shift is good, listed for
/// a swap; a crowded leaf is listed for a shift-split if that has a good point, else for a split; a thin node
/// is listed for a merge. The walk does not go below a node where an operator acted or was listed. `process`
/// applies listed events in the order shift-split, split, swap, merge until the budget is spent; the rest is
/// deferred. No traversal happens while events other than merges are pending.
template <int D>
class Scheduler {
 public:
  /// Lines 1 to 12. Does nothing while events are pending, between two scheduling steps, or without a budget.
  /// Entries beyond their cap are shed, and leaves in bulk divided, in any step that has a budget.
  template <class Trace>
  void traverse(Tree<D>& tree, const Config& config, std::uint32_t step, Reporter<Trace>& reporter);
  /// Lines 13 to 18.
  template <class Trace>
  void process(Tree<D>& tree, const Config& config, std::uint32_t step, Reporter<Trace>& reporter);

  /// Whether neither would find anything to do: the whole tree is a leaf, and not a crowded one.
  [[nodiscard]] bool is_idle(const Tree<D>& tree, const Config& config) const;

  /// Events listed for `op`, oldest first. Balance is never listed.
  [[nodiscard]] const std::vector<NodeRef>& listed(Operator op) const { return lists_[index(op)]; }
  [[nodiscard]] std::uint32_t pending() const;
  /// Operators that acted, by kind, since the beginning.
  [[nodiscard]] const std::array<std::uint64_t, kOperatorCount>& acted() const { return acted_; }
  /// `seed` mixed with the pending events: they decide the next steps as much as the tree does.
  [[nodiscard]] std::uint64_t mix_into(std::uint64_t seed) const;
  /// Operators refused or dropped since the beginning.
  [[nodiscard]] std::uint64_t refused() const { return refused_; }
  /// Takes over the lists and counts of another scheduler. `lists` has one list for each operator.
  void resume(std::array<std::vector<NodeRef>, kOperatorCount> lists,
              const std::array<std::uint64_t, kOperatorCount>& acted, std::uint64_t refused) {
    lists_ = std::move(lists);
    acted_ = acted;
    refused_ = refused;
  }

 private:
  static std::size_t index(Operator op) { return static_cast<std::size_t>(op); }
  template <class Trace>
  class Call;

  std::array<std::vector<NodeRef>, kOperatorCount> lists_;
  std::array<std::uint64_t, kOperatorCount> acted_{};
  std::uint64_t refused_ = 0;
};

}  // namespace kerf
