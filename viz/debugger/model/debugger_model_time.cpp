#include <algorithm>
#include <iterator>

#include "viz/debugger/model/debugger_model.h"

namespace kerf {
namespace {

/// The item after or before a moment.
std::optional<Position> beside(const std::set<Position>& items, const Position& moment, bool forwards) {
  const auto next = forwards ? items.upper_bound(moment) : items.lower_bound(moment);
  if (forwards) return next == items.end() ? std::nullopt : std::optional(*next);
  return next == items.begin() ? std::nullopt : std::optional(*std::prev(next));
}

}  // namespace

std::optional<Position> DebuggerModel::find_kind(EventKind kind, bool forwards,
                                                 const Run::Progress& progress) {
  const Position& here = run_->position();
  if (kind == EventKind::bookmark) {
    std::set<Position> marked;
    for (const auto& [moment, note] : bookmarks) marked.insert(moment);
    return beside(marked, here, forwards);
  }
  if (kind != EventKind::alarm) return find_event(*run_, kind, here, forwards, progress);
  std::set<Position> wrong;
  for (const std::uint32_t step : wrong_steps_) wrong.insert(Position::end_of(step));
  return beside(wrong, here, forwards);
}

void DebuggerModel::go_to_kind(EventKind kind, bool forwards) {
  timeline.kind = kind;
  bool ended = false;
  const auto found = find_kind(kind, forwards, noticing(ended));
  const std::string name(to_string(kind));
  if (ended) return say("ended before the kind '" + name + "' was found");
  if (!found) return say("nothing of the kind '" + name + (forwards ? "' further on" : "' further back"));
  go(*found);
  say(name + " at " + to_string(*found, run_->names()));
}

/// One step or event further; from the end of a range that loops to its beginning.
void DebuggerModel::play_on() {
  if (!timeline.loops || !timeline.range) return step(plays_by, true);
  const Position begin = Position::end_of(timeline.range->first - 1);
  const Position end = Position::end_of(timeline.range->last);
  const auto goes_on = [&] { return run_->step(plays_by, true) && run_->position() <= end; };
  if (run_->position() < begin || !goes_on()) {
    run_->go(begin);
    playing = goes_on();
    if (!playing) {
      run_->go(begin);
      say("the range has nothing to play");
    }
  }
  moved();
  hovered_candidate = run_->candidate();
}

void DebuggerModel::zoom_lanes(double factor) {
  TimeWindow& window = timeline.window;
  const double now = time_of(run_->position(), run_->rows());
  const bool is_seen = window.first() <= now && now <= window.last();
  const double around = is_seen ? now : window.first() + 0.5 * window.span();
  window.zoom(factor, around, least_span(around, run_->rows()));
}

/// The step of this moment that a range can begin or end at; none in an empty run.
std::optional<std::uint32_t> DebuggerModel::step_of_range() {
  if (run_->steps() > 0) return std::max(1U, run_->position().step);
  say("the run has no steps to select");
  return std::nullopt;
}

void DebuggerModel::begin_range() {
  const auto step = step_of_range();
  if (step) timeline.range = StepSpan{*step, std::max(*step, timeline.range ? timeline.range->last : *step)};
}

void DebuggerModel::end_range() {
  const auto step = step_of_range();
  if (step) timeline.range = StepSpan{std::min(*step, timeline.range ? timeline.range->first : *step), *step};
}

void DebuggerModel::drop_range() {
  timeline.range.reset();
  timeline.loops = false;
}

void DebuggerModel::toggle_loop() {
  if (!timeline.range)
    return say("select a range first: S and E at its ends, or Shift and a drag over the lanes");
  timeline.loops = !timeline.loops;
}

void DebuggerModel::show_range() {
  const TimeWindow seen = timeline.window;
  if (timeline.range) timeline.window.show(timeline.range->first - 1.0, timeline.range->last);
  if (!timeline.range || seen == timeline.window) timeline.window.show_all();
}

void DebuggerModel::go_to_extreme(bool greatest) {
  const Lane& lane = lanes_[timeline.lane];
  const std::uint32_t step = greatest ? lane.greatest_step() : lane.least_step();
  if (step == 0) return say("the lane " + std::string(lane.name()) + " has no values");
  go(Position::end_of(step));
}

}  // namespace kerf
