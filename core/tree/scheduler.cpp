#include "core/tree/scheduler.h"

#include <algorithm>
#include <optional>

#include "core/base/random.h"
#include "core/base/short_stack.h"
#include "core/base/tuning.h"
#include "core/tree/balance.h"
#include "core/tree/criteria.h"
#include "core/tree/merge.h"
#include "core/tree/shed.h"
#include "core/tree/shift_split.h"
#include "core/tree/split.h"
#include "core/tree/swap.h"

namespace kerf {
namespace {

/// The order in which Algorithm 1 processes its lists (lines 14 to 17).
constexpr std::array kProcessingOrder{Operator::shift_split, Operator::split, Operator::swap,
                                      Operator::merge};

/// A leaf whose split was refused is left alone for 1, 2, 4, 8, 16 scheduling intervals. Where no partitioner
/// divides, as when all objects coincide, a search in each interval would cost more than the sweep.
template <int D>
void back_off(Tree<D>& tree, NodeId leaf, const Config& config, std::uint32_t step) {
  Node<D>& node = tree[leaf];
  node.retry_step = step + (config.schedule_interval << std::min(node.refusals, tuning::kMostWaits));
  ++node.refusals;
}

template <int D>
bool still_wanted(const Tree<D>& tree, Operator op, NodeId id, const Config& config) {
  switch (op) {
    case Operator::shift_split:
    case Operator::split:
      return wants_split(tree, id, config);
    case Operator::swap:
      return wants_swap(tree, id, config);
    case Operator::balance:
      return config.balance && wants_repair(tree, id, config);
    case Operator::merge:
      return wants_merge(tree, id, config);
  }
  return false;
}

}  // namespace

template <int D>
std::uint32_t Scheduler<D>::pending() const {
  std::size_t sum = 0;
  for (const std::vector<NodeRef>& list : lists_) sum += list.size();
  return static_cast<std::uint32_t>(sum);
}

template <int D>
std::uint64_t Scheduler<D>::mix_into(std::uint64_t seed) const {
  for (const std::vector<NodeRef>& list : lists_) {
    seed = Random(seed ^ list.size()).bits();
    for (const NodeRef& ref : list)
      seed = Random(seed ^ ((std::uint64_t{ref.generation} << 32U) | ref.node.value)).bits();
  }
  return seed;
}

template <int D>
bool Scheduler<D>::is_idle(const Tree<D>& tree, const Config& config) const {
  if (!tree[tree.root()].is_leaf() || pending() > 0) return false;
  const auto threshold = static_cast<float>(split_threshold(tree.objects(), config));
  return static_cast<float>(tree.objects()) <= std::min(config.bulk_factor, 1.0F) * threshold;
}

/// One call of `traverse` or `process`, and what it works on.
template <int D>
template <class Trace>
class Scheduler<D>::Call {
 public:
  Call(Scheduler& scheduler, Tree<D>& tree, const Config& config, std::uint32_t step,
       Reporter<Trace>& reporter)
      : scheduler_(scheduler), tree_(tree), config_(config), step_(step), reporter_(reporter) {}

  void traverse() {
    if (config_.budget_divisor == 0) return;
    for (const OperatorActed& event : shed_entries(tree_, config_)) report_acted(event);
    if (config_.split && config_.bulk_factor > 0) divide_bulk();
    std::vector<NodeRef>& merges = list(Operator::merge);
    if (step_ % config_.schedule_interval != 0 || scheduler_.pending() > merges.size()) return;
    merges.clear();  // those still needed are found again
    ShortStack<NodeId> todo(tree_.root());
    while (!todo.empty()) {
      const NodeId id = todo.pop();
      if (visit(id) || tree_[id].is_leaf()) continue;
      todo.push(tree_[id].right);
      todo.push(tree_[id].left);
    }
  }

  void process() {
    const std::uint32_t waiting = scheduler_.pending();
    if (waiting == 0) return;
    const std::uint32_t divisor = config_.budget_divisor;
    std::uint32_t budget = divisor == 0 ? 0 : (waiting + divisor - 1) / divisor;
    for (const Operator op : kProcessingOrder) {
      std::vector<NodeRef>& due = list(op);
      std::size_t done = 0;
      while (done < due.size() && budget > 0)
        if (apply(op, due[done++])) --budget;
      due.erase(due.begin(), due.begin() + static_cast<std::ptrdiff_t>(done));
    }
    if (const std::uint32_t left = scheduler_.pending(); left > 0)
      reporter_.report([&] { return EventsDeferred{left}; });
  }

 private:
  [[nodiscard]] std::vector<NodeRef>& list(Operator op) { return scheduler_.lists_[index(op)]; }

  /// Splits leaves that are many times too large, and their children, until none is too large. Otherwise
  /// thousands of objects that came together would be swept in few leaves, and divided over many steps.
  void divide_bulk() {
    struct Due {
      NodeId node;
      float most = 0;  ///< the most objects of a leaf that is not divided
    };
    const auto threshold = static_cast<float>(split_threshold(tree_.objects(), config_));
    ShortStack<Due> todo({tree_.root(), config_.bulk_factor * threshold});
    while (!todo.empty()) {
      const auto [id, most] = todo.pop();
      const bool is_bulk = tree_[id].is_leaf() && static_cast<float>(tree_[id].population) > most;
      if (is_bulk && tree_[id].retry_step <= step_) divide_leaf(Operator::split, tree_.ref(id));
      if (tree_[id].is_leaf()) continue;
      todo.push({tree_[id].right, is_bulk ? threshold : most});
      todo.push({tree_[id].left, is_bulk ? threshold : most});
    }
  }

  /// Lines 3 to 10 for one node. True if an operator acted or was due, so that its subtrees are not visited.
  bool visit(NodeId id) {
    if (wants_repair(tree_, id, config_) && repair(id)) return true;
    if (wants_split(tree_, id, config_) && tree_[id].retry_step <= step_) {
      if (scheduler_.pending() >= config_.event_capacity) {  // the search for a point would be in vain
        refuse(Operator::split, tree_.ref(id), Refusal::list_full);
        return true;
      }
      const bool shift = config_.shift_split && shifted_partitioner(tree_, id, config_).has_value();
      schedule(shift ? Operator::shift_split : Operator::split, id);
      return true;
    }
    if (wants_merge(tree_, id, config_)) {
      schedule(Operator::merge, id);
      return true;
    }
    return false;
  }

  /// Lines 4 to 7: balances the node or, if no shift is good, lists it for a swap.
  bool repair(NodeId id) {
    Refusal refusal{};
    std::optional<OperatorActed> event;
    if (config_.balance && !refuse_if_decided(Operator::balance, id))
      event = balance(tree_, id, config_, refusal);
    if (event) {
      report_acted(*event);
      return true;
    }
    if (!wants_swap(tree_, id, config_)) return false;
    schedule(Operator::swap, id);
    return true;
  }

  void schedule(Operator op, NodeId id) {
    if (scheduler_.pending() >= config_.event_capacity) return refuse(op, tree_.ref(id), Refusal::list_full);
    list(op).push_back(tree_.ref(id));
    reporter_.report([&] { return OperatorScheduled{op, tree_.ref(id)}; });
  }

  /// Applies one listed event. False if it was dropped without any work.
  bool apply(Operator op, NodeRef ref) {
    const bool alive = tree_.is_alive(ref);
    if (!alive || !still_wanted(tree_, op, ref.node, config_)) {
      refuse(op, ref, alive ? Refusal::not_needed : Refusal::dead_node);
      return false;
    }
    const bool divides = op == Operator::shift_split || op == Operator::split;
    if (!divides && refuse_if_decided(op, ref.node)) return true;
    if (op == Operator::swap) {
      const NodeId heavy = heavier_child(tree_, ref.node);
      report_acted(swap(tree_, ref.node));
      if (config_.swap_rest > 0 && tree_[heavy].is_leaf())
        tree_[heavy].retry_step = step_ + config_.swap_rest * config_.schedule_interval;
    } else if (op == Operator::merge) {
      report_acted(merge(tree_, ref.node));
    } else {
      divide_leaf(op, ref);
    }
    return true;
  }

  /// Refuses the operator if a decision does, and returns whether it did.
  bool refuse_if_decided(Operator op, NodeId id) {
    if (!reporter_.refuses(op)) return false;
    refuse(op, tree_.ref(id), Refusal::decided);
    return true;
  }

  /// Shift-split first; only if it fails the split is performed (section 5.2).
  void divide_leaf(Operator op, NodeRef ref) {
    Refusal refusal{};
    std::optional<OperatorActed> event;
    if (op == Operator::shift_split && !refuse_if_decided(op, ref.node))
      event = shift_split(tree_, ref.node, config_, refusal);
    if (!event) event = split(tree_, ref.node, config_, reporter_.decision(Operator::split), refusal);
    if (event) return report_acted(*event);
    back_off(tree_, ref.node, config_, step_);
    refuse(op, ref, refusal);
  }

  void report_acted(const OperatorActed& event) {
    ++scheduler_.acted_[index(event.op)];
    reporter_.report([&] { return event; });
  }

  void refuse(Operator op, NodeRef ref, Refusal reason) {
    ++scheduler_.refused_;
    reporter_.report([&] { return OperatorRefused{op, ref, reason}; });
  }

  Scheduler& scheduler_;
  Tree<D>& tree_;
  const Config& config_;
  std::uint32_t step_;
  Reporter<Trace>& reporter_;
};

template <int D>
template <class Trace>
void Scheduler<D>::traverse(Tree<D>& tree, const Config& config, std::uint32_t step,
                            Reporter<Trace>& reporter) {
  Call<Trace>(*this, tree, config, step, reporter).traverse();
}

template <int D>
template <class Trace>
void Scheduler<D>::process(Tree<D>& tree, const Config& config, std::uint32_t step,
                           Reporter<Trace>& reporter) {
  Call<Trace>(*this, tree, config, step, reporter).process();
}

template class Scheduler<2>;
template class Scheduler<3>;

#define KERF_INSTANTIATE(D, TRACE)                                                                       \
  template void Scheduler<D>::traverse<TRACE>(Tree<D>&, const Config&, std::uint32_t, Reporter<TRACE>&); \
  template void Scheduler<D>::process<TRACE>(Tree<D>&, const Config&, std::uint32_t, Reporter<TRACE>&);
KERF_FOR_EACH_TRACE(KERF_INSTANTIATE)
#undef KERF_INSTANTIATE

}  // namespace kerf
