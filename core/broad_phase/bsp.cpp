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
std::shared_ptr<const Projector<D>> make_projector(const Config& config, VolumeKind kind) {
  check(config);
  const std::uint32_t size = D == 3 ? config.directions : std::max<std::uint32_t>(D, config.directions / 4);
  return std::make_shared<const Projector<D>>(DirectionSet<D>(size, config.seed), kind);
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
Bsp<D, Trace>::Bsp(const Config& config, VolumeKind kind)
    : config_(config), tree_(make_projector<D>(config, kind)), latest_(kind) {}

template <int D, class Trace>
void Bsp<D, Trace>::set_config(const Config& config) {
  check(config);
  if (config.directions != config_.directions || config.seed != config_.seed)
    throw std::invalid_argument("directions and seed cannot change while the tree lives: make a new one");
  config_ = config;
}

/// Remembers that an object changed, unless the request was refused.
template <int D, class Trace>
Status Bsp<D, Trace>::note(ObjectId object, Status status) {
  if (status == Status::unknown_id || status == Status::duplicate_id) return status;
  if (changing_.size() <= object.index()) changing_.resize(object.index() + 1, 0);
  if (changing_[object.index()] == 0) changed_.push_back(object);
  changing_[object.index()] = 1;
  return status;
}

template <int D, class Trace>
Status Bsp<D, Trace>::insert(ObjectId object, const Box<D>& box, Mobility mobility) {
  return note(object, latest_.insert(object, box, mobility));
}

template <int D, class Trace>
Status Bsp<D, Trace>::insert(ObjectId object, const Volume<D>& volume, Mobility mobility) {
  return note(object, latest_.insert(object, volume, mobility));
}

template <int D, class Trace>
Status Bsp<D, Trace>::move(ObjectId object, const Box<D>& box) {
  return note(object, latest_.move(object, box));
}

template <int D, class Trace>
Status Bsp<D, Trace>::move(ObjectId object, const Volume<D>& volume) {
  return note(object, latest_.move(object, volume));
}

template <int D, class Trace>
Status Bsp<D, Trace>::remove(ObjectId object) {
  return note(object, latest_.remove(object));
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
  std::vector<ObjectId> leaving;
  std::vector<ObjectId> entering;
  for (const ObjectId object : changed_) {
    changing_[object.index()] = 0;
    const bool was_placed = tree_.table.is_placed(object);
    const bool is_placed = latest_.is_placed(object);
    if (was_placed && is_placed && stays(tree_, object, latest_.volume(object))) continue;
    if (was_placed) leaving.push_back(object);
    if (is_placed) entering.push_back(object);
    if (was_placed && !is_placed) reporter_.report([&] { return ObjectPlaced{object, 0}; });
  }
  displace<D>(tree_, tree_.root(), leaving);
  for (const ObjectId object : changed_) tree_.table.copy(latest_, object);
  changed_.clear();
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
