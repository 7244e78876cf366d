#include "core/broad_phase/bsp.h"

#include <chrono>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "core/kernels/sweep.h"
#include "core/tree/hash.h"
#include "core/tree/placement.h"
#include "core/tree/subtree.h"

namespace kerf {
namespace {

template <int D>
std::shared_ptr<const DirectionSet<D>> make_directions(const Config& config) {
  check(config);
  const std::uint32_t size = D == 3 ? config.directions : std::max<std::uint32_t>(D, config.directions / 4);
  return std::make_shared<const DirectionSet<D>>(size, config.seed);
}

/// Renews and orders the lists of the leaves that something changed.
template <int D>
void sort_leaves(Tree<D>& tree) {
  for_each_node(tree, tree.root(), [&tree](NodeId id) {
    if (!tree[id].unsorted) return;
    renew_keys(tree, id);
    sort_entries(tree[id].entries);
    tree[id].unsorted = false;
  });
}

}  // namespace

template <int D, class Trace>
Bsp<D, Trace>::Bsp(const Config& config) : config_(config), tree_(make_directions<D>(config)) {}

template <int D, class Trace>
void Bsp<D, Trace>::set_config(const Config& config) {
  check(config);
  if (config.directions != config_.directions || config.seed != config_.seed)
    throw std::invalid_argument("directions and seed cannot change while the tree lives: make a new one");
  config_ = config;
}

/// Remembers where an object lies in the tree, before its box changes for the first time in this step.
template <int D, class Trace>
void Bsp<D, Trace>::remember(ObjectId object) {
  if (changing_.size() <= object.index()) changing_.resize(object.index() + 1, 0);
  if (changing_[object.index()] != 0) return;
  changing_[object.index()] = 1;
  const bool placed = tree_.table.is_placed(object);
  changes_.push_back({object, placed, placed ? tree_.table.box(object) : Box<D>{}});
}

template <int D, class Trace>
Status Bsp<D, Trace>::insert(ObjectId object, const Box<D>& box, Mobility mobility) {
  if (object.is_none()) return Status::unknown_id;
  if (tree_.table.state(object) != ObjectState::absent) return Status::duplicate_id;
  remember(object);
  return tree_.table.insert(object, box, mobility);
}

template <int D, class Trace>
Status Bsp<D, Trace>::move(ObjectId object, const Box<D>& box) {
  if (tree_.table.state(object) == ObjectState::absent) return Status::unknown_id;
  remember(object);
  return tree_.table.move(object, box);
}

template <int D, class Trace>
Status Bsp<D, Trace>::remove(ObjectId object) {
  if (tree_.table.state(object) == ObjectState::absent) return Status::unknown_id;
  remember(object);
  return tree_.table.remove(object);
}

template <int D, class Trace>
void Bsp<D, Trace>::step() {
  ++step_;
  reporter_.begin_step(step_);
  begin(Phase::place);
  place_changes();
  begin(Phase::sort);
  sort_leaves(tree_);
  begin(Phase::schedule);
  scheduler_.traverse(tree_, config_, step_, reporter_);
  begin(Phase::operate);
  scheduler_.process(tree_, config_, step_, reporter_);
  sort_leaves(tree_);
  begin(Phase::sweep);
  sweep();
  end_phase();
}

/// Brings the entries up to date with the table. Placement is never deferred: it is what makes the pairs
/// complete.
template <int D, class Trace>
void Bsp<D, Trace>::place_changes() {
  std::vector<Leaving<D>> leaving;
  std::vector<ObjectId> entering;
  for (const Change& change : changes_) {
    changing_[change.object.index()] = 0;
    const bool placed = tree_.table.is_placed(change.object);
    if (change.was_placed && placed && stays(tree_, change.old_box, tree_.table.box(change.object))) continue;
    if (change.was_placed) leaving.push_back({change.object, change.old_box});
    if (placed) entering.push_back(change.object);
    if (change.was_placed && !placed) reporter_.report([&] { return ObjectPlaced{change.object, 0}; });
  }
  changes_.clear();
  displace<D>(tree_, tree_.root(), leaving);
  for (const ObjectId object : entering) {
    const std::uint32_t leaves = place(tree_, tree_.root(), object, 0);
    reporter_.report([&] { return ObjectPlaced{object, leaves}; });
  }
  placed_ = entering.size();
}

template <int D, class Trace>
void Bsp<D, Trace>::sweep() {
  pairs_.clear();
  for_each_node(tree_, tree_.root(), [this](NodeId id) {
    if (tree_[id].is_leaf()) sweep_leaf(tree_.table, tree_[id], buffer_, pairs_);
  });
}

template <int D, class Trace>
void Bsp<D, Trace>::begin(Phase phase) {
  end_phase();
  phase_ = phase;
  reporter_.report([&] { return PhaseBegan{phase}; });
}

template <int D, class Trace>
void Bsp<D, Trace>::end_phase() {
  const auto now = std::chrono::steady_clock::now();
  phase_seconds_[static_cast<std::size_t>(phase_)] =
      std::chrono::duration<double>(now - phase_start_).count();
  phase_start_ = now;
}

template <int D, class Trace>
Statistics Bsp<D, Trace>::statistics() const {
  Statistics s;
  s.objects = tree_.objects();
  s.entries = tree_.entries();
  s.redundancy = s.objects == 0 ? 0 : static_cast<double>(s.entries) / s.objects - 1;
  for_each_node(tree_, tree_.root(), [&](NodeId id) {
    if (!tree_[id].is_leaf()) return;
    ++s.leaves;
    s.height = std::max(s.height, tree_[id].depth);
  });
  s.operators = scheduler_.acted();
  s.refused = scheduler_.refused();
  s.deferred = scheduler_.pending();
  s.placed = placed_;
  s.phase_seconds = phase_seconds_;
  return s;
}

template <int D, class Trace>
std::uint64_t Bsp<D, Trace>::state_hash() const {
  return scheduler_.mix_into(hash(tree_));
}

template class Bsp<2, NoTrace>;
template class Bsp<3, NoTrace>;
template class Bsp<2, EventLog>;
template class Bsp<3, EventLog>;

}  // namespace kerf
