#include "viz/debugger/session/session.h"

#include <algorithm>
#include <array>

#include "core/base/counted.h"
#include "core/recording/chain.h"

namespace kerf {
namespace {

std::string hash_of_steps(const Run& run, std::uint32_t steps) {
  std::uint64_t hash = static_cast<std::uint64_t>(run.info().dimension);
  for (const StepRow& row : run.rows().first(steps))
    hash = hash_words(std::array{row.events, row.operators_hash, row.state_hash, row.pairs_hash}, hash);
  return to_hex(hash);
}

bool has_moment(const Run& run, const Position& moment) {
  return moment.step <= run.steps() && (moment.is_end() || run.step_of(moment.event) == moment.step);
}

/// "2 bookmarks, " if there are any.
std::string listed(std::size_t count, const std::string& one, const std::string& many) {
  return count == 0 ? "" : counted(count, one, many) + ", ";
}

bool has_thing(Run& run, const Selection& selection) {
  return std::visit(Overloaded{[](std::monostate) { return true; }, [](NodeId) { return true; },
                               [&](ObjectId object) { return run.knows(object); },
                               [&](const Pair& pair) { return pair.a < pair.b && run.knows(pair.b); }},
                    selection);
}

/// Returns how many the run cannot answer; they are left out.
std::size_t go_on_with_stops(const DebuggerSession& session, DebuggerModel& model) {
  std::size_t left_out = 0;
  const auto adds = [&](auto add) {
    try {
      add();
      return true;
    } catch (const std::invalid_argument&) {
      ++left_out;
      return false;
    }
  };
  model.breakpoints.clear();
  for (const DebuggerSession::Stop& stop : session.breakpoints)
    if (adds([&] { model.add_breakpoint(stop.condition); })) model.breakpoints.back().enabled = stop.enabled;
  while (!model.watches().empty()) model.remove_watch(0);
  for (const DebuggerSession::Watch& watch : session.watches)
    if (adds([&] { model.add_watch(watch.expression); }))
      model.stop_at_watch(model.watches().size() - 1, watch.stop);
  return left_out;
}

void go_on_with_lanes(const DebuggerSession::Lanes& lanes, DebuggerModel& model) {
  Timeline& timeline = model.timeline;
  timeline.window.show(lanes.first, lanes.last);
  const auto named = std::ranges::find(model.lanes(), lanes.lane, &Lane::name);
  if (named != model.lanes().end()) timeline.lane = static_cast<std::size_t>(named - model.lanes().begin());
  timeline.clips = lanes.clips;
  timeline.kind = lanes.kind;
  const bool has_range = lanes.range && lanes.range->last <= model.run().steps();
  timeline.range = has_range ? lanes.range : std::nullopt;
  timeline.loops = has_range && lanes.loops;
}

/// The notes of both; a part that both have comes once.
std::string join_notes(std::string first, const std::string& second) {
  static const std::string kBetween = " / ";
  const std::string rest = second + kBetween;
  for (std::size_t begin = 0, end = 0; begin < rest.size(); begin = end + kBetween.size()) {
    end = rest.find(kBetween, begin);
    const std::string part = rest.substr(begin, end - begin);
    const std::string whole = kBetween + first + kBetween;
    if (part.empty() || whole.find(kBetween + part + kBetween) != std::string::npos) continue;
    first += (first.empty() ? "" : kBetween) + part;
  }
  return first;
}

}  // namespace

DebuggerSession session_of(const DebuggerModel& model, const AnyCamera& camera) {
  const Timeline& timeline = model.timeline;
  DebuggerSession session{
      mark_of(model.run()),   {}, {}, model.bookmarks, model.view, camera, model.selection(),
      model.run().position(), {}};
  for (const Breakpoint& breakpoint : model.breakpoints)
    session.breakpoints.push_back({breakpoint.condition.text(), breakpoint.enabled});
  for (const WatchedValue& watch : model.watches())
    session.watches.push_back({watch.expression.text(), watch.stop});
  session.lanes = {timeline.window.first(),
                   timeline.window.last(),
                   std::string(model.lanes()[timeline.lane].name()),
                   timeline.clips,
                   timeline.range,
                   timeline.loops,
                   timeline.kind};
  return session;
}

std::string go_on(const DebuggerSession& session, DebuggerModel& model) {
  Run& run = model.run();
  std::string left_out = listed(go_on_with_stops(session, model), "condition", "conditions");
  model.bookmarks = session.bookmarks;
  const std::size_t beyond =
      std::erase_if(model.bookmarks, [&](const auto& mark) { return !has_moment(run, mark.first); });
  left_out += listed(beyond, "bookmark", "bookmarks");
  model.view = session.view;
  const bool has_place = has_moment(run, session.position);
  if (has_place) model.go(session.position);
  if (!has_place) left_out += "the moment, ";
  const bool has_selection = has_thing(run, session.selection);
  model.select(has_selection ? session.selection : Selection());
  if (!has_selection) left_out += "the selection, ";
  go_on_with_lanes(session.lanes, model);
  return left_out.substr(0, left_out.size() - std::min<std::size_t>(left_out.size(), 2));
}

RecordingMark mark_of(const Run& run) {
  return {run.info().scene, run.info().dimension, run.steps(), hash_of_steps(run, run.steps())};
}

bool is_of(const RecordingMark& mark, const Run& run) {
  return mark.dimension == run.info().dimension && mark.steps <= run.steps() &&
         mark.hash == hash_of_steps(run, mark.steps);
}

bool has_anything(const DebuggerSession& session) {
  return !session.breakpoints.empty() || !session.watches.empty() || !session.bookmarks.empty() ||
         session.view != ViewSettings() || !is_nothing(session.selection) || session.lanes.range.has_value();
}

std::string to_text(const DebuggerSession& session, const GivenNames& names) {
  return listed(session.breakpoints.size(), "breakpoint", "breakpoints") +
         listed(session.watches.size(), "watch", "watches") +
         listed(session.bookmarks.size(), "bookmark", "bookmarks") + to_string(session.position, names);
}

DebuggerSession join(DebuggerSession first, const DebuggerSession& second) {
  for (const DebuggerSession::Stop& stop : second.breakpoints) {
    const auto same = std::ranges::find(first.breakpoints, stop.condition, &DebuggerSession::Stop::condition);
    if (same == first.breakpoints.end()) {
      first.breakpoints.push_back(stop);
    } else {
      same->enabled = same->enabled || stop.enabled;
    }
  }
  for (const DebuggerSession::Watch& watch : second.watches) {
    const auto same = std::ranges::find(first.watches, watch.expression, &DebuggerSession::Watch::expression);
    if (same == first.watches.end()) {
      first.watches.push_back(watch);
    } else if (!same->stop) {
      same->stop = watch.stop;
    }
  }
  for (const auto& [moment, note] : second.bookmarks) {
    std::string& joined = first.bookmarks[moment];
    joined = join_notes(std::move(joined), note);
  }
  return first;
}

bool holds(const DebuggerSession& first, const DebuggerSession& second) {
  const DebuggerSession both = join(first, second);
  const auto has = [](const auto& found, const auto& wanted, const auto& nothing) {
    return wanted == nothing || wanted == found;
  };
  return both.breakpoints == first.breakpoints && both.watches == first.watches &&
         both.bookmarks == first.bookmarks && has(first.view, second.view, ViewSettings()) &&
         has(first.lanes.range, second.lanes.range, std::optional<StepSpan>());
}

}  // namespace kerf
