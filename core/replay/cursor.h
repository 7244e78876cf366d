#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/replay/position.h"
#include "core/replay/replayer.h"
#include "core/tree/ballot.h"

namespace kerf {

/// A moment of a recorded run, also in the middle of a step, that moves forwards and backwards. It is the
/// debugger's model and independent of windows.
///
/// Everything throws std::runtime_error for moments that the recording does not have, or if it is damaged.
template <int D>
class Cursor {
 public:
  explicit Cursor(std::shared_ptr<RecordingReader<D>> recording);

  [[nodiscard]] const Position& position() const { return position_; }
  void go(const Position& position);
  void go_to_step(std::uint32_t step) { go(Position::end_of(step)); }
  void go_to_event(std::uint64_t event);

  /// False if there is nothing further in that direction; then nothing changes.
  bool forward(Granularity granularity);
  bool backward(Granularity granularity);

  /// The complete state of the tree at this moment. The pairs are those of the last sweep.
  [[nodiscard]] const BspState<D>& state() const { return state_; }
  /// The event that has just happened; none at the end of a step.
  [[nodiscard]] std::optional<Event> event() const;
  /// The candidates among which the operator that has just acted chose; empty otherwise.
  [[nodiscard]] const std::vector<BallotEntry>& candidates();
  /// The present candidate; none unless the cursor moved by candidates.
  [[nodiscard]] std::optional<std::size_t> candidate() const { return candidate_; }

  [[nodiscard]] Replayer<D>& replayer() { return replayer_; }
  [[nodiscard]] RecordingReader<D>& recording() const { return *recording_; }

 private:
  using Wanted = std::function<bool(const Event&)>;

  [[nodiscard]] std::optional<Position> next(const Wanted& wanted, bool step_ends) const;
  [[nodiscard]] std::optional<Position> previous(const Wanted& wanted, bool step_ends) const;
  [[nodiscard]] std::optional<Position> target(Granularity granularity, bool forwards) const;
  bool go_by_candidate(bool forwards);

  std::shared_ptr<RecordingReader<D>> recording_;
  Replayer<D> replayer_;
  Position position_;
  BspState<D> state_;
  std::optional<std::vector<BallotEntry>> candidates_;  ///< none: not computed yet
  std::optional<std::size_t> candidate_;
};

/// The state of the tree right after and right before an event. Throws std::runtime_error if there is no such
/// event.
template <int D>
BspState<D> state_after(Replayer<D>& replayer, std::uint64_t event);
template <int D>
BspState<D> state_before(Replayer<D>& replayer, std::uint64_t event);

/// The candidates among which an operator chose, or a split that was refused might have; empty for any other
/// event.
template <int D>
std::vector<BallotEntry> ballot_of(const BspState<D>& before, const Event& event);

}  // namespace kerf
