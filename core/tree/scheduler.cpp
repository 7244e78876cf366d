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

template <int D>
template <class Trace>
void Scheduler<D>::traverse(Tree<D>& tree, const Config& config, std::uint32_t step,
                            Reporter<Trace>& reporter) {
  if (config.budget_divisor != 0)
    for (const OperatorActed& event : shed_entries(tree, config)) note(event, reporter);
  if (config.budget_divisor != 0 && config.split && config.bulk_factor > 0)
    divide_bulk(tree, config, step, reporter);
  std::vector<NodeRef>& merges = lists_[index(Operator::merge)];
  if (config.budget_divisor == 0 || step % config.schedule_interval != 0 || pending() > merges.size()) return;
  merges.clear();  // those still needed are found again
  ShortStack<NodeId> todo(tree.root());
  while (!todo.empty()) {
    const NodeId id = todo.pop();
    if (visit(tree, id, config, step, reporter) || tree[id].is_leaf()) continue;
    todo.push(tree[id].right);
    todo.push(tree[id].left);
  }
}

/// Splits leaves that are many times too large, and their children, until none is too large. Otherwise
/// thousands of objects that came together would be swept in few leaves, and divided over many steps.
template <int D>
template <class Trace>
void Scheduler<D>::divide_bulk(Tree<D>& tree, const Config& config, std::uint32_t step,
                               Reporter<Trace>& reporter) {
  struct Due {
    NodeId node;
    float most = 0;  ///< the most objects of a leaf that is not divided
  };
  const auto threshold = static_cast<float>(split_threshold(tree.objects(), config));
  ShortStack<Due> todo({tree.root(), config.bulk_factor * threshold});
  while (!todo.empty()) {
    const auto [id, most] = todo.pop();
    const bool is_bulk = tree[id].is_leaf() && static_cast<float>(tree[id].population) > most;
    if (is_bulk && tree[id].retry_step <= step)
      divide_leaf(tree, Operator::split, tree.ref(id), config, step, reporter);
    if (tree[id].is_leaf()) continue;
    todo.push({tree[id].right, is_bulk ? threshold : most});
    todo.push({tree[id].left, is_bulk ? threshold : most});
  }
}

/// Lines 3 to 10 for one node. True if an operator acted or was due, so that its subtrees are not visited.
template <int D>
template <class Trace>
bool Scheduler<D>::visit(Tree<D>& tree, NodeId id, const Config& config, std::uint32_t step,
                         Reporter<Trace>& reporter) {
  if (wants_repair(tree, id, config) && repair(tree, id, config, reporter)) return true;
  if (wants_split(tree, id, config) && tree[id].retry_step <= step) {
    if (pending() >= config.event_capacity) {  // the search for a point would be in vain
      refuse(Operator::split, tree.ref(id), Refusal::list_full, reporter);
      return true;
    }
    const bool shift = config.shift_split && shifted_partitioner(tree, id, config).has_value();
    schedule(tree, shift ? Operator::shift_split : Operator::split, id, config, reporter);
    return true;
  }
  if (wants_merge(tree, id, config)) {
    schedule(tree, Operator::merge, id, config, reporter);
    return true;
  }
  return false;
}

/// Lines 4 to 7: balances the node or, if no shift is good, lists it for a swap.
template <int D>
template <class Trace>
bool Scheduler<D>::repair(Tree<D>& tree, NodeId id, const Config& config, Reporter<Trace>& reporter) {
  Refusal refusal{};
  std::optional<OperatorActed> event;
  if (config.balance && !refuse_if_decided(tree, Operator::balance, id, reporter))
    event = balance(tree, id, config, refusal);
  if (event) {
    note(*event, reporter);
    return true;
  }
  if (!wants_swap(tree, id, config)) return false;
  schedule(tree, Operator::swap, id, config, reporter);
  return true;
}

template <int D>
template <class Trace>
void Scheduler<D>::schedule(const Tree<D>& tree, Operator op, NodeId id, const Config& config,
                            Reporter<Trace>& reporter) {
  if (pending() >= config.event_capacity) {
    refuse(op, tree.ref(id), Refusal::list_full, reporter);
    return;
  }
  lists_[index(op)].push_back(tree.ref(id));
  reporter.report([&] { return OperatorScheduled{op, tree.ref(id)}; });
}

template <int D>
template <class Trace>
void Scheduler<D>::process(Tree<D>& tree, const Config& config, std::uint32_t step,
                           Reporter<Trace>& reporter) {
  const std::uint32_t waiting = pending();
  if (waiting == 0) return;
  const std::uint32_t divisor = config.budget_divisor;
  std::uint32_t budget = divisor == 0 ? 0 : (waiting + divisor - 1) / divisor;
  for (const Operator op : kProcessingOrder) {
    std::vector<NodeRef>& list = lists_[index(op)];
    std::size_t done = 0;
    while (done < list.size() && budget > 0)
      if (apply(tree, op, list[done++], config, step, reporter)) --budget;
    list.erase(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(done));
  }
  if (const std::uint32_t left = pending(); left > 0) reporter.report([&] { return EventsDeferred{left}; });
}

/// Applies one listed event. False if it was dropped without any work.
template <int D>
template <class Trace>
bool Scheduler<D>::apply(Tree<D>& tree, Operator op, NodeRef ref, const Config& config, std::uint32_t step,
                         Reporter<Trace>& reporter) {
  const bool alive = tree.is_alive(ref);
  if (!alive || !still_wanted(tree, op, ref.node, config)) {
    refuse(op, ref, alive ? Refusal::not_needed : Refusal::dead_node, reporter);
    return false;
  }
  const bool divides = op == Operator::shift_split || op == Operator::split;
  if (!divides && refuse_if_decided(tree, op, ref.node, reporter)) return true;
  if (op == Operator::swap) {
    const NodeId heavy = heavier_child(tree, ref.node);
    note(swap(tree, ref.node), reporter);
    if (config.swap_rest > 0 && tree[heavy].is_leaf())
      tree[heavy].retry_step = step + config.swap_rest * config.schedule_interval;
  } else if (op == Operator::merge) {
    note(merge(tree, ref.node), reporter);
  } else {
    divide_leaf(tree, op, ref, config, step, reporter);
  }
  return true;
}

/// Refuses the operator if a decision does, and returns whether it did.
template <int D>
template <class Trace>
bool Scheduler<D>::refuse_if_decided(const Tree<D>& tree, Operator op, NodeId id, Reporter<Trace>& reporter) {
  if (!reporter.refuses(op)) return false;
  refuse(op, tree.ref(id), Refusal::decided, reporter);
  return true;
}

/// Shift-split first; only if it fails the split is performed (section 5.2).
template <int D>
template <class Trace>
void Scheduler<D>::divide_leaf(Tree<D>& tree, Operator op, NodeRef ref, const Config& config,
                               std::uint32_t step, Reporter<Trace>& reporter) {
  Refusal refusal{};
  std::optional<OperatorActed> event;
  if (op == Operator::shift_split && !refuse_if_decided(tree, op, ref.node, reporter))
    event = shift_split(tree, ref.node, config, refusal);
  if (!event) event = split(tree, ref.node, config, reporter.decision(Operator::split), refusal);
  if (event) {
    note(*event, reporter);
  } else {
    back_off(tree, ref.node, config, step);
    refuse(op, ref, refusal, reporter);
  }
}

template <int D>
template <class Trace>
void Scheduler<D>::note(const OperatorActed& event, Reporter<Trace>& reporter) {
  ++acted_[index(event.op)];
  reporter.report([&] { return event; });
}

template <int D>
template <class Trace>
void Scheduler<D>::refuse(Operator op, NodeRef ref, Refusal reason, Reporter<Trace>& reporter) {
  ++refused_;
  reporter.report([&] { return OperatorRefused{op, ref, reason}; });
}

template class Scheduler<2>;
template class Scheduler<3>;

#define KERF_INSTANTIATE(D, TRACE)                                                                       \
  template void Scheduler<D>::traverse<TRACE>(Tree<D>&, const Config&, std::uint32_t, Reporter<TRACE>&); \
  template void Scheduler<D>::process<TRACE>(Tree<D>&, const Config&, std::uint32_t, Reporter<TRACE>&);
KERF_FOR_EACH_TRACE(KERF_INSTANTIATE)
#undef KERF_INSTANTIATE

}  // namespace kerf
