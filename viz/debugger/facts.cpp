#include <algorithm>
#include <cmath>

#include "core/query/text.h"
#include "viz/debugger/debugger.h"

namespace kerf {
namespace {

using Facts = std::map<std::string, std::string>;

void add_moment(Facts& facts, const Run& run) {
  facts["position"] = to_string(run.position(), run.names());
  facts["step"] = run.names().step(run.position().step);
  const auto event = run.event();
  facts["event"] = event ? "e" + std::to_string(event->id) : "none";
  facts["deed"] = event ? describe(*event, run.names()) : "none";
  facts["state"] = to_hex(run.state_hash());
  facts["steps"] = std::to_string(run.steps());
  facts["pairs"] = std::to_string(run.pairs().size());
  facts["objects"] = std::to_string(run.objects());
}

std::string_view match_word(Counterpart::Match match) {
  if (match == Counterpart::Match::none) return "none";
  return match == Counterpart::Match::same ? "same" : "different";
}

void add_other(Facts& facts, DebuggerModel& model) {
  const Run* const other = model.other();
  facts["comparing"] = other == nullptr ? "no" : "yes";
  facts["other"] = other == nullptr ? "none" : to_string(other->position(), other->names());
  const auto event = other == nullptr ? std::nullopt : other->event();
  facts["other_deed"] = event ? describe(*event, other->names()) : "none";
  facts["match"] = other == nullptr ? "none" : match_word(model.match());
}

void add_view(Facts& facts, const SceneView& view) {
  facts["labels"] = "";
  const ShownCounts& counts = view.counts();
  facts["drawn_objects"] = std::to_string(counts.objects);
  facts["all_objects"] = std::to_string(counts.all_objects);
  facts["drawn_partitioners"] = std::to_string(counts.partitioners);
  facts["drawn_pairs"] = std::to_string(counts.pairs);
  facts["drawn_missed"] = std::to_string(counts.missed);
  facts["query"] = counts.query.empty() ? "none" : counts.query;
  facts["drawn_extra"] = std::to_string(counts.extra);
  for (const SceneLabel& label : view.labels()) facts["labels"] += label.text + "; ";
  facts["tint_end"] = number_text(counts.tint_end);
  facts["pictures"] = std::to_string(view.drawn());
}

void add_stops(Facts& facts, const DebuggerModel& model) {
  facts["breakpoints"] = std::to_string(model.breakpoints.size());
  for (std::size_t k = 0; k < model.breakpoints.size(); ++k) {
    facts["breakpoint" + std::to_string(k)] = model.breakpoints[k].condition.text();
    facts["hits" + std::to_string(k)] = std::to_string(model.breakpoints[k].hits);
  }
  facts["watches"] = std::to_string(model.watches().size());
  for (std::size_t k = 0; k < model.watches().size(); ++k) {
    const ConditionNumber& value = model.watches()[k].value;
    facts["watch_hits" + std::to_string(k)] = std::to_string(model.watches()[k].hits);
    facts["watch" + std::to_string(k)] = value.exists() ? to_text(value) : "none";
  }
}

/// Errors of another engine are of the whole run.
void add_errors(Facts& facts, DebuggerModel& model) {
  const auto error = model.wrong_pair();
  facts["errors"] = std::to_string(model.run().wrong_pairs().size());
  facts["error"] = error ? std::to_string(*error + 1) : "none";
  facts["judged_steps"] = std::to_string(model.alarms().size());
  facts["wrong_steps"] = std::to_string(model.wrong_steps().size());
}

void add_theirs(Facts& facts, DebuggerModel& model, const SceneView& view) {
  const bool is_known = model.run().has_their_structure();
  facts["structure"] = !is_known ? "ours alone" : model.view.theirs ? "theirs" : "ours";
  facts["their_nodes"] = std::to_string(model.run().their_nodes());
  facts["their_faults"] = std::to_string(model.run().their_faults().size());
  facts["drawn_nodes_of_theirs"] = std::to_string(view.counts().their_nodes);
}

std::string value_text(const std::optional<double>& value) { return value ? number_text(*value) : "none"; }

void add_lanes(Facts& facts, const DebuggerModel& model) {
  const Timeline& timeline = model.timeline;
  const Lane& lane = model.lanes()[timeline.lane];
  facts["lanes_from"] = number_text(timeline.window.first(), 10);
  facts["lanes_to"] = number_text(timeline.window.last(), 10);
  facts["loops"] = timeline.loops ? "yes" : "no";
  facts["range"] = timeline.range ? to_text(figures_of(*timeline.range, model.run().rows(), model.lanes()),
                                            model.run().names())
                                  : "none";
  facts["kind"] = to_string(timeline.kind);
  facts["lane"] = lane.name();
  facts["lane_min"] = value_text(lane.value(lane.least_step()));
  facts["lane_max"] = value_text(lane.value(lane.greatest_step()));
  facts["lane_scale"] = number_text(double{lane.scale_end(timeline.clips)});
  facts["lane_above"] = std::to_string(timeline.clips ? lane.above() : 0);
}

void add_session(Facts& facts, const SessionMemory& session, const DebuggerModel& model) {
  facts["offer"] = session.offer.empty() ? "none" : session.offer;
  facts["offer_warning"] = session.offer_warning.empty() ? "none" : session.offer_warning;
  std::size_t k = 0;
  for (const auto& [moment, note] : model.bookmarks) {
    facts["bookmark" + std::to_string(k)] = to_string(moment, model.run().names());
    facts["note" + std::to_string(k++)] = note;
  }
}

}  // namespace

std::map<std::string, std::string> Debugger::facts() {
  Facts facts;
  add_moment(facts, model_.run());
  add_view(facts, *view_);
  facts["other_tint_end"] = other_view_ ? number_text(other_view_->counts().tint_end) : "none";
  add_stops(facts, model_);
  add_other(facts, model_);
  add_lanes(facts, model_);
  add_errors(facts, model_);
  add_theirs(facts, model_, *view_);
  facts["selection"] = to_string(model_.selection(), model_.run().names());
  facts["playing"] = model_.playing ? "yes" : "no";
  facts["bookmarks"] = std::to_string(model_.bookmarks.size());
  add_session(facts, memory_.session, model_);
  facts["recording"] = recording_.filename().string();
  facts["changes"] = std::to_string(history_.changes());
  facts["taken_back"] = std::to_string(history_.taken_back());
  facts["hidden"] = std::to_string(model_.view.hidden_nodes.size() + model_.view.hidden_objects.size());
  facts["alone"] = model_.view.isolated ? node_text(*model_.view.isolated) : "none";
  if (view_->counts().lacks_isolated) facts["alone"] += ", not alive here";
  facts["colour"] = kTintNames[static_cast<std::size_t>(model_.view.tint)];
  facts["layers"] = to_string(model_.view.layers);
  facts["hovered_node"] = model_.hovered_node ? "n" + std::to_string(model_.hovered_node->value) : "none";
  facts["icicle"] = memory_.before_operator ? "before" : "now";
  facts["theme"] = kThemeNames[static_cast<std::size_t>(memory_.window.theme)];
  facts["panel_pictures"] = std::to_string(panel_pictures_);
  facts["zoom"] = number_text(memory_.window.zoom);
  facts["scale"] = number_text(scale());
  facts["window"] = to_text(memory_.window);
  std::ranges::replace(facts["window"], '\n', ';');
  facts["pointer"] = kPointerNames[static_cast<std::size_t>(gui_.pointer())];
  facts["copied"] = memory_.copied;
  facts["table"] = kTableNames[static_cast<std::size_t>(memory_.table_of)];
  const TableKeeper& kept = memory_.table;
  facts["table_rows"] = std::to_string(kept.rows().size());
  facts["table_first"] = kept.rows().empty() ? "none" : kept.table().rows[kept.rows()[0]].name;
  facts["lanes"] = std::to_string(model_.lanes().size());
  facts["welcome"] = memory_.welcome ? "yes" : "no";
  facts["tour"] = memory_.tour ? std::to_string(*memory_.tour + 1) : "none";
  facts["under_mouse"] = memory_.under_mouse;
  facts["search"] = memory_.search.is_open ? "open: " + memory_.search.text : "closed";
  facts["help"] = memory_.help ? "yes" : "no";
  facts["explanation"] = memory_.explanation;
  facts["problem"] = memory_.problem;
  facts["message"] = model_.message;
  facts["candidate"] = model_.hovered_candidate ? std::to_string(*model_.hovered_candidate) : "none";
  const auto& ballot = model_.run().ballot();
  const std::size_t shown = model_.hovered_candidate.value_or(ballot.size());
  facts["candidate_plane"] = shown < ballot.size() ? ballot[shown].plane : "none";
  facts["candidates"] = std::to_string(model_.run().ballot().size());
  facts["panel_ms"] = number_text(1e3 * panel_seconds_);
  return facts;
}

}  // namespace kerf
