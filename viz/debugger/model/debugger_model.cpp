#include "viz/debugger/model/debugger_model.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include "core/base/overloaded.h"
#include "core/base/shortest_text.h"
#include "core/trace/event_facts.h"
#include "viz/debugger/model/opening.h"

namespace kerf {
namespace {

/// Brute force takes a few milliseconds for so many objects, and its time grows with their square.
constexpr std::uint32_t kMostForOracle = 8000;

/// Objects times steps: with more of them the lanes of an object take longer than a second.
constexpr std::uint64_t kMostForLanes = 3'000'000;

template <class T>
void toggle(std::set<T>& set, const T& item) {
  if (!set.erase(item)) set.insert(item);
}

Ribbon::Kind kind_of_ribbon(const Event& event) {
  if (has_acted(event)) return Ribbon::Kind::acted;
  return is_outcome(event) ? Ribbon::Kind::refused : Ribbon::Kind::listed;
}

}  // namespace

DebuggerModel::DebuggerModel(std::unique_ptr<Run> run)
    : run_(std::move(run)), lanes_(make_lanes(run_->rows())) {
  timeline.window = TimeWindow(run_->steps());
  take_verdicts();
  moved();
}

void DebuggerModel::say(std::string text, bool is_error) {
  message = std::move(text);
  message_is_error = is_error;
}

void DebuggerModel::moved() {
  hovered_candidate.reset();
  timeline.window.reveal(time_of(run_->position(), run_->rows()));
  if (other_) follow();
  for (WatchedValue& watch : watches_) watch.value = run_->value(watch.expression);
  if (asks_oracle && run_->objects() <= kMostForOracle) (void)ask_oracle();
}

/// Moves the other run to the moment of this one.
void DebuggerModel::follow() {
  const Position& here = run_->position();
  const Counterpart counterpart =
      find_counterpart(here, run_->events_of_step(), other_->events_of(here.step), other_->steps());
  other_->go(counterpart.position);
  match_ = counterpart.match;
}

void DebuggerModel::go(const Position& position) {
  Position within = position;
  if (within.step > run_->steps()) within = Position::end_of(run_->steps());
  if (within == run_->position()) return;
  run_->go(within);
  moved();
}

void DebuggerModel::go_to_opening() { go(Position::end_of(opening_step(run_->rows()))); }

void DebuggerModel::go_to_event(std::uint64_t event) {
  const auto step = run_->step_of(event);
  if (!step) return say("the recording has no event e" + std::to_string(event), true);
  go({*step, event});
}

void DebuggerModel::step(Granularity wanted, bool forwards) {
  if (!run_->step(wanted, forwards)) {
    playing = false;
    return say(forwards ? "there is nothing further on" : "there is nothing further back");
  }
  moved();
  hovered_candidate = run_->candidate();
}

void DebuggerModel::run_to_breakpoint(bool forwards) {
  const auto stops = [](const WatchedValue& watch) { return watch.stop.has_value(); };
  if (std::ranges::none_of(breakpoints, &Breakpoint::enabled) && std::ranges::none_of(watches_, stops))
    return say("there is no breakpoint to run to: add one on the left, or press F9 at an event");
  bool ended = false;
  const auto stop = next_stop(*run_, breakpoints, watches_, forwards, noticing(ended));
  if (ended) return say("ended before a breakpoint was found");
  if (!stop) return say(forwards ? "no breakpoint holds further on" : "no breakpoint holds further back");
  go(stop->position);
  say("stopped at " + to_string(stop->position, run_->names()) + ": " + count_hit(*stop));
}

void DebuggerModel::go_to_condition(const std::string& condition, bool forwards) {
  bool ended = false;
  const auto stop = next_stop(*run_, {{Expression::parse(condition)}}, {}, forwards, noticing(ended));
  if (ended) return say("ended before the condition was found to hold");
  if (!stop) return say(condition + (forwards ? " holds nowhere further on" : " holds nowhere further back"));
  go(stop->position);
  say(condition + " holds");
}

/// Says what stopped the run.
std::string DebuggerModel::count_hit(const Stop& stop) {
  if (stop.breakpoint) {
    Breakpoint& breakpoint = breakpoints[*stop.breakpoint];
    ++breakpoint.hits;
    return breakpoint.condition.text();
  }
  WatchedValue& watch = watches_[*stop.watch];
  ++watch.hits;
  const bool becomes_true = watch.stop == Change::becomes_true;
  return watch.expression.text() + (becomes_true ? " is true now" : " has changed");
}

/// `on_long_work`, which also records whether it ended the work.
Run::Progress DebuggerModel::noticing(bool& ended) const {
  return [this, &ended](std::uint32_t step) {
    if (!ended && on_long_work) ended = !on_long_work(step);
    return !ended;
  };
}

void DebuggerModel::pass_time(double seconds) {
  if (!playing) {
    due_ = 0;
    return;
  }
  due_ += seconds * speed;
  for (; due_ >= 1 && playing; due_ -= 1) play_on();
}

double DebuggerModel::seconds_to_next() const {
  return playing ? (1 - due_) / speed : std::numeric_limits<double>::infinity();
}

void DebuggerModel::select(const Selection& selection) {
  if (selection_ == selection) return;
  ribbons_.reset();
  shown_ribbons_.reset();
  drop_object_lanes();
  selection_ = selection;
  const std::uint64_t work = std::uint64_t{run_->steps()} * run_->objects();
  if (object_in(selection_) && work <= kMostForLanes) show_object_lanes();
}

void DebuggerModel::ask(const std::string& query) {
  static_cast<void>(run_->explain_query(query));
  view.query = query;
  select({});
}

void DebuggerModel::deselect() {
  if (is_nothing(selection_)) view.query.clear();
  select({});
}

void DebuggerModel::add_node_ribbons(NodeId node) {
  const auto add = [&](const LifeSpan& span, Ribbon::Kind kind) {
    ribbons_->push_back({span.first_step, span.last_step.value_or(run_->steps()), kind});
  };
  for (const NodeLife& life : run_->lives(node)) {
    add(life.span, Ribbon::Kind::life);
    for (const LifeSpan& span : life.divided) add(span, Ribbon::Kind::divided);
  }
  for (const Event& event : run_->history(node))
    ribbons_->push_back({event.step, event.step, kind_of_ribbon(event)});
}

void DebuggerModel::add_pair_ribbons(const Pair& pair) {
  for (const PairChange& change : run_->history(pair)) {
    if (change.is_pair) ribbons_->push_back({change.step, run_->steps(), Ribbon::Kind::pair});
    if (!change.is_pair && !ribbons_->empty()) ribbons_->back().last_step = change.step - 1;
  }
}

const std::vector<Ribbon>& DebuggerModel::ribbons() {
  if (ribbons_) return *ribbons_;
  ribbons_.emplace();
  std::visit(
      Overloaded{[&](NodeId node) { add_node_ribbons(node); },
                 [&](const Pair& pair) { add_pair_ribbons(pair); },
                 [&](ObjectId /*object*/) { add_object_ribbons(); }, NothingFor<void, std::monostate>()},
      selection_);
  return *ribbons_;
}

const std::vector<Ribbon>& DebuggerModel::shown_ribbons(const TimeScale& scale) {
  if (!shown_ribbons_ || shown_scale_ != scale) shown_ribbons_ = thin_out(ribbons(), scale);
  shown_scale_ = scale;
  return *shown_ribbons_;
}

void DebuggerModel::select_object(ObjectId object, bool makes_pair) {
  const auto first = object_in(selection_);
  if (makes_pair && first && *first != object) return select(make_pair(*first, object));
  select(object);
}

bool DebuggerModel::is_selected(NodeId node) const { return node_in(selection_) == node; }

void DebuggerModel::toggle_hidden() {
  const auto refuse = [&] { say("select a node or an object to hide it"); };
  std::visit(Overloaded{[&](NodeId node) { toggle(view.hidden_nodes, node); },
                        [&](ObjectId object) { toggle(view.hidden_objects, object); },
                        [&](std::monostate) { refuse(); }, [&](const Pair&) { refuse(); }},
             selection_);
}

void DebuggerModel::show_all() {
  view.hidden_nodes.clear();
  view.hidden_objects.clear();
  view.isolated.reset();
}

void DebuggerModel::toggle_isolated() {
  const auto node = node_in(selection_);
  if (view.isolated) {
    view.isolated.reset();
  } else if (node) {
    view.isolated = *node;
  } else {
    say("select a node to see only what is below it");
  }
}

void DebuggerModel::add_breakpoint(const std::string& condition) {
  Breakpoint breakpoint{Expression::parse(condition)};
  run_->check(breakpoint.condition);
  breakpoints.push_back(std::move(breakpoint));
}

void DebuggerModel::add_watch(const std::string& expression) {
  WatchedValue watch{Expression::parse_value(expression)};
  watch.value = run_->value(watch.expression);
  watches_.push_back(std::move(watch));
}

void DebuggerModel::stop_at_watch(std::size_t k, std::optional<Change> change) { watches_[k].stop = change; }

void DebuggerModel::remove_breakpoint(std::size_t k) {
  breakpoints.erase(breakpoints.begin() + static_cast<std::ptrdiff_t>(k));
}

void DebuggerModel::remove_watch(std::size_t k) {
  watches_.erase(watches_.begin() + static_cast<std::ptrdiff_t>(k));
}

void DebuggerModel::toggle_breakpoint_here() {
  const Position& here = run_->position();
  const std::string text = here.is_end() ? "step==" + shortest_text(run_->names().step_number(here.step))
                                         : "event==" + std::to_string(here.event);
  const auto same = [&](const Breakpoint& breakpoint) { return breakpoint.condition.text() == text; };
  if (std::erase_if(breakpoints, same) == 0) add_breakpoint(text);
}

void DebuggerModel::toggle_bookmark() {
  if (bookmarks.erase(run_->position()) == 0) bookmarks.emplace(run_->position(), "");
}

void DebuggerModel::compare_with(std::unique_ptr<Run> other) {
  if (other->info().dimension != run_->info().dimension)
    throw std::runtime_error("a run in 2D and one in 3D cannot be compared");
  comparison_.reset();
  other_ = std::move(other);
  other_lanes_ = make_lanes(other_->rows());
  moved();
}

void DebuggerModel::what_if(const WhatIfQuestion& question) {
  const auto out = work_folder / ("what-if-" + std::to_string(++reruns_) + ".kerf");
  bool ended = false;
  run_->rerun(question, out, noticing(ended));
  compare_with(open_run(out));
  say("compared with " + out.filename().string() + (ended ? ", which was ended early" : ""));
}

void DebuggerModel::change_over() {
  if (!other_) return;
  select({});  // its lanes are of this run
  std::swap(run_, other_);
  std::swap(lanes_, other_lanes_);
  comparison_.reset();
  findings_.reset();
  take_verdicts();
  const TimeWindow seen = std::exchange(timeline.window, TimeWindow(run_->steps()));
  if (timeline.range && timeline.range->last > run_->steps()) drop_range();
  if (!seen.shows_all()) timeline.window.show(seen.first(), seen.last());
  moved();
}

void DebuggerModel::stop_comparing() {
  other_.reset();
  comparison_.reset();
}

void DebuggerModel::go_to_first_different_operator() {
  if (!other_) return;
  const auto& difference = comparison().operators;
  if (!difference) return say("no operator acted or was refused otherwise");
  const auto moment = [&](const std::optional<Event>& event) {
    return event ? Position{event->step, event->id} : Position::end_of(difference->step);
  };
  go(moment(difference->a));
  other_->go(moment(difference->b));
  const bool both = difference->a && difference->b;
  if (match_ != Counterpart::Match::different || !both) match_ = Counterpart::Match::none;
  say("the first different operator");
}

const RecordingComparison& DebuggerModel::comparison() {
  if (!comparison_) comparison_ = run_->compare(*other_);
  return *comparison_;
}

const std::vector<Thrash>& DebuggerModel::lint(std::uint32_t within) {
  if (!findings_ || findings_within_ != within) findings_ = run_->lint(within);
  findings_within_ = within;
  return *findings_;
}

}  // namespace kerf
