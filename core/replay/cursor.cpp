#include "core/replay/cursor.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "core/base/float_mode.h"
#include "core/trace/event_facts.h"

namespace kerf {
namespace {

struct Contest {
  Operator op;
  NodeRef node;
};

/// The choice of an operator: it placed a partitioner, or a split found none.
std::optional<Contest> contest_of(const Event& event) {
  if (const auto* const acted = acted_of(event)) {
    if (acted->op == Operator::merge || acted->op == Operator::swap) return std::nullopt;
    return Contest{acted->op, acted->node};
  }
  const auto* const refused = refused_of(event);
  if (refused == nullptr || refused->reason != Refusal::no_partitioner) return std::nullopt;
  return Contest{Operator::split, refused->node};
}

/// After a decision another candidate acted than Algorithm 1 would have chosen.
void mark_decided(const OperatorActed& acted, std::vector<BallotEntry>& entries) {
  if (acted.op != Operator::split) return;
  for (BallotEntry& entry : entries) {
    const bool has_acted = entry.direction == acted.direction && entry.offset == acted.new_offset;
    const bool is_own_choice = entry.result == Ballot::chosen;
    entry.taken = has_acted && !is_own_choice;
    if (is_own_choice && !has_acted) entry.result = Ballot::overruled;
  }
}

template <int D>
std::uint32_t step_of(const RecordingReader<D>& recording, std::uint64_t event) {
  const auto step = recording.step_of(event);
  if (!step) throw std::runtime_error("the recording has no event e" + std::to_string(event));
  return *step;
}

}  // namespace

/// Runs the step of the event to its end and copies the tree on the way.
template <int D>
BspState<D> state_after(Replayer<D>& replayer, std::uint64_t event) {
  std::optional<BspState<D>> state;
  const Event recorded = replayer.recording().event(event);
  replayer.seek(recorded.step - 1);
  replayer.advance([&](const Event& happened) {
    if (happened == recorded) state = replayer.tree().state();
  });
  if (!state)
    throw std::runtime_error("the replay has no event e" + std::to_string(event) +
                             ": `kerf verify` says more");
  return *std::move(state);
}

template <int D>
BspState<D> state_before(Replayer<D>& replayer, std::uint64_t event) {
  const std::uint32_t step = step_of(replayer.recording(), event);
  if (event != replayer.recording().row(step).first_event) return state_after(replayer, event - 1);
  replayer.seek(step - 1);
  return replayer.tree().state();
}

template <int D>
std::vector<BallotEntry> ballot_of(const BspState<D>& before, const Event& event) {
  const DefaultFloats floats;
  const auto contest = contest_of(event);
  if (!contest || !before.tree.is_alive(contest->node)) return {};
  const NodeId node = contest->node.node;
  if (contest->op == Operator::split && !before.tree[node].is_leaf()) return {};  // of no run of this tree
  std::vector<BallotEntry> entries = ballot(before.tree, contest->op, node, before.config);
  if (const auto* const acted = acted_of(event)) mark_decided(*acted, entries);
  return entries;
}

template <int D>
Cursor<D>::Cursor(std::shared_ptr<RecordingReader<D>> recording)
    : recording_(std::move(recording)), replayer_(recording_), state_(replayer_.tree().state()) {}

template <int D>
void Cursor<D>::go(const Position& position) {
  if (position.is_end()) {
    replayer_.seek(position.step);
    state_ = replayer_.tree().state();
  } else {
    state_ = state_after(replayer_, position.event);
  }
  position_ = position;
  candidates_.reset();
  candidate_.reset();
}

template <int D>
void Cursor<D>::go_to_event(std::uint64_t event) {
  go({step_of(*recording_, event), event});
}

template <int D>
std::optional<Event> Cursor<D>::event() const {
  if (position_.is_end()) return std::nullopt;
  const std::vector<Event>& events = recording_->step(position_.step).events;
  return events[position_.event - recording_->row(position_.step).first_event];
}

template <int D>
std::optional<Position> Cursor<D>::next(const Wanted& wanted, bool step_ends) const {
  const bool is_end = position_.is_end();
  for (std::uint32_t step = position_.step + (is_end ? 1 : 0); step <= recording_->steps(); ++step) {
    for (const Event& event : recording_->step(step).events) {
      const bool passed = step == position_.step && event.id <= position_.event;
      if (!passed && wanted(event)) return Position{step, event.id};
    }
    if (step_ends) return Position::end_of(step);
  }
  return std::nullopt;
}

template <int D>
std::optional<Position> Cursor<D>::previous(const Wanted& wanted, bool step_ends) const {
  for (std::uint32_t step = position_.step; step > 0; --step) {
    if (step_ends && step < position_.step) return Position::end_of(step);
    const std::vector<Event>& events = recording_->step(step).events;
    for (auto event = events.rbegin(); event != events.rend(); ++event)
      if (event->id < position_.event && wanted(*event)) return Position{step, event->id};
  }
  if (step_ends && position_.step > 0) return Position::end_of(0);
  return std::nullopt;
}

template <int D>
std::optional<Position> Cursor<D>::target(Granularity granularity, bool forwards) const {
  const auto seek = [&](const Wanted& wanted, bool step_ends) {
    return forwards ? next(wanted, step_ends) : previous(wanted, step_ends);
  };
  const Position last = Position::end_of(forwards ? recording_->steps() : 0);
  switch (granularity) {
    case Granularity::run:
      return last == position_ ? std::nullopt : std::optional(last);
    case Granularity::step:
      return seek([](const Event& /*any*/) { return false; }, true);
    case Granularity::phase:
      return seek(begins_phase, true);
    case Granularity::op:
      return seek(is_outcome, false);
    case Granularity::event:
      return seek([](const Event& /*any*/) { return true; }, true);
    case Granularity::candidate:
      return seek([](const Event& event) { return contest_of(event).has_value(); }, false);
  }
  return std::nullopt;
}

template <int D>
bool Cursor<D>::forward(Granularity granularity) {
  if (granularity == Granularity::candidate) return go_by_candidate(true);
  const auto to = target(granularity, true);
  if (to) go(*to);
  return to.has_value();
}

template <int D>
bool Cursor<D>::backward(Granularity granularity) {
  if (granularity == Granularity::candidate) return go_by_candidate(false);
  const auto to = target(granularity, false);
  if (to) go(*to);
  return to.has_value();
}

/// Within a ballot, then on to the first of the next one or the last of the one before.
template <int D>
bool Cursor<D>::go_by_candidate(bool forwards) {
  const std::size_t count = candidates().size();
  const std::size_t next = candidate_ ? *candidate_ + 1 : 0;
  if (forwards && next < count) {
    candidate_ = next;
    return true;
  }
  if (!forwards && candidate_ && *candidate_ > 0) {
    --*candidate_;
    return true;
  }
  const auto to = target(Granularity::candidate, forwards);
  if (!to) return false;
  go(*to);
  if (!candidates().empty()) candidate_ = forwards ? 0 : candidates().size() - 1;
  return true;
}

template <int D>
const std::vector<BallotEntry>& Cursor<D>::candidates() {
  if (candidates_) return *candidates_;
  candidates_.emplace();
  const auto happened = event();
  if (happened && contest_of(*happened))
    candidates_ = ballot_of(state_before(replayer_, happened->id), *happened);
  return *candidates_;
}

#define KERF_INSTANTIATE(D)                                                         \
  template BspState<D> state_after<D>(Replayer<D>&, std::uint64_t);                 \
  template BspState<D> state_before<D>(Replayer<D>&, std::uint64_t);                \
  template std::vector<BallotEntry> ballot_of<D>(const BspState<D>&, const Event&); \
  template class Cursor<D>;
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
