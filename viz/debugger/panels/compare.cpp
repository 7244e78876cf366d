#include <algorithm>
#include <stdexcept>

#include "core/query/text.h"
#include "viz/debugger/gui/widgets.h"
#include "viz/debugger/panels/copying.h"
#include "viz/debugger/panels/panel.h"
#include "viz/draw/palette.h"

namespace kerf {
namespace {

void open_other(PanelContext& context) {
  try {
    context.model.compare_with(open_run(context.memory.other_file));
  } catch (const std::runtime_error& error) {
    context.memory.problem = error.what();
    context.model.message = error.what();
    context.model.message_is_error = true;
  }
}

void figure_row(const ComparedFigure& figure) {
  ImGui::TableNextRow();
  for (const std::string& text : {figure.name, number_text(figure.a), number_text(figure.b)}) {
    ImGui::TableNextColumn();
    if (figure.a != figure.b) {
      ImGui::TextUnformatted(text.c_str());
    } else {
      ImGui::TextDisabled("%s", text.c_str());
    }
  }
}

void draw_figures(const RecordingComparison& comparison) {
  if (!ImGui::BeginTable("figures", 3, ImGuiTableFlags_RowBg)) return;
  ImGui::TableSetupColumn("");
  ImGui::TableSetupColumn("this run");
  ImGui::TableSetupColumn("the other");
  ImGui::TableHeadersRow();
  for (const ComparedFigure& figure : compared_figures(comparison)) figure_row(figure);
  ImGui::EndTable();
}

void draw_difference(PanelContext& context, const char* what, const std::optional<std::uint32_t>& step) {
  if (!step) return ImGui::TextDisabled("%s %s", what, context.model.comparison().same_words());
  ImGui::Text("%s differ first in", what);
  ImGui::SameLine();
  const std::string label = "step " + context.model.run().names().step(*step) + "##" + what;
  const bool pressed = ImGui::SmallButton(label.c_str());
  context.gui.name_last_item(std::string("first different ") + what, label);
  if (pressed) context.model.go(Position::end_of(*step));
}

/// The first few of what only one of two has.
void draw_only(std::string text, const std::vector<std::string>& all) {
  constexpr std::size_t kMost = 5;
  if (all.empty()) return;
  for (std::size_t k = 0; k < std::min(kMost, all.size()); ++k) text += " " + all[k];
  if (all.size() > kMost) text += " and " + std::to_string(all.size() - kMost) + " more";
  widgets::wrapped_text(text);
}

std::string text_of(const std::optional<Event>& event, const GivenNames& names) {
  return event ? describe(*event, names) : "nothing more";
}

void draw_difference(PanelContext& context, const char* what,
                     const std::optional<EventDifference>& difference) {
  draw_difference(context, what, difference ? std::optional(difference->step) : std::nullopt);
  if (!difference) return;
  widgets::wrapped_text("  this: " + text_of(difference->a, context.model.run().names()));
  widgets::wrapped_text("  other: " + text_of(difference->b, context.model.other()->names()));
}

/// An operator that is also the first different event is not shown twice.
void draw_operators(PanelContext& context, const RecordingComparison& comparison) {
  if (!comparison.operators || comparison.operators != comparison.events)
    draw_difference(context, "operators", comparison.operators);
  if (!comparison.operators) return;
  if (widgets::button(context.gui, "show both", "this run goes to its operator, the other one to its own",
                      "first different operator"))
    context.model.go_to_first_different_operator();
}

/// The moment of the other run, and whether it has done the same.
void draw_other_moment(DebuggerModel& model) {
  const Run& other = *model.other();
  const auto event = other.event();
  const std::string moment =
      event ? describe(*event, other.names()) : "end of step " + other.names().step(other.position().step);
  const bool same = model.match() == Counterpart::Match::same;
  const char* const match = same                                             ? "the same"
                            : model.match() == Counterpart::Match::different ? "the same with another outcome"
                                                                             : "nothing like it";
  ImGui::PushStyleColor(ImGuiCol_Text, widgets::to_vector(same ? palette::kInk : palette::kCandidate));
  widgets::wrapped_text(std::string("the other: ") + match + ", " + moment);
  ImGui::PopStyleColor();
}

}  // namespace

std::vector<ComparedFigure> compared_figures(const RecordingComparison& comparison) {
  std::vector<ComparedFigure> figures;
  const auto add = [&](std::string name, auto of) {
    figures.push_back(
        {std::move(name), static_cast<double>(of(comparison.a)), static_cast<double>(of(comparison.b))});
  };
  using Summary = RecordingSummary;
  add("steps", [](const Summary& run) { return run.steps; });
  for (std::size_t op = 0; op < comparison.a.operators.size(); ++op)
    add(std::string(to_string(static_cast<Operator>(op))),
        [op](const Summary& run) { return run.operators[op]; });
  add("refused", [](const Summary& run) { return run.refused; });
  add("pairs", [](const Summary& run) { return run.pairs; });
  add("height", [](const Summary& run) { return run.height; });
  add("redundancy", [](const Summary& run) { return run.redundancy; });
  add("ms, median", [](const Summary& run) { return run.milliseconds; });
  return figures;
}

void draw_compare(PanelContext& context) {
  DebuggerModel& model = context.model;
  if (model.other() == nullptr) {
    ImGui::TextWrapped("%s",
                       "Two recordings side by side: the other one goes where this one goes, and its curves "
                       "lie over these. \"What if\" makes one, or open one:");
    if (widgets::text_field(context.gui, "other file", context.memory.other_file, "a recording, then Enter",
                            -1))
      open_other(context);
    return;
  }
  if (widgets::button(context.gui, "stop comparing")) return model.stop_comparing();
  ImGui::SameLine();
  if (widgets::button(context.gui, "change over", "go on in the other run")) return model.change_over();
  ImGui::SameLine();
  widgets::text_within(context.gui, "with " + model.other()->path().filename().string(), palette::kFaintInk,
                       ImGui::GetContentRegionAvail().x);
  draw_other_moment(model);
  const RecordingComparison& comparison = model.comparison();
  draw_only("steps only here:", comparison.steps_only_a);
  draw_only("steps only in the other:", comparison.steps_only_b);
  draw_only("objects only here:", comparison.objects_only_a);
  draw_only("objects only in the other:", comparison.objects_only_b);
  draw_difference(context, "requests", comparison.requests);
  draw_difference(context, "events", comparison.events);
  draw_operators(context, comparison);
  draw_difference(context, "trees", comparison.state);
  draw_difference(context, "pairs", comparison.pairs);
  if (model.run().info().imported) {
    draw_difference(context, "their pairs",
                    comparison.theirs ? std::optional(comparison.theirs->step) : std::nullopt);
    draw_difference(context, "verdicts", comparison.verdicts);
  }
  draw_figures(comparison);
}

}  // namespace kerf
