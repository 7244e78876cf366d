#include <stdexcept>

#include "core/query/text.h"
#include "viz/debugger/gui/widgets.h"
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

void figure_row(const char* name, double a, double b) {
  ImGui::TableNextRow();
  for (const std::string& text : {std::string(name), number_text(a), number_text(b)}) {
    ImGui::TableNextColumn();
    if (a != b) {
      ImGui::TextUnformatted(text.c_str());
    } else {
      ImGui::TextDisabled("%s", text.c_str());
    }
  }
}

void draw_figures(const RecordingSummary& a, const RecordingSummary& b) {
  if (!ImGui::BeginTable("figures", 3, ImGuiTableFlags_RowBg)) return;
  ImGui::TableSetupColumn("");
  ImGui::TableSetupColumn("this run");
  ImGui::TableSetupColumn("the other");
  ImGui::TableHeadersRow();
  figure_row("steps", a.steps, b.steps);
  for (std::size_t op = 0; op < a.operators.size(); ++op)
    figure_row(to_string(static_cast<Operator>(op)).data(), static_cast<double>(a.operators[op]),
               static_cast<double>(b.operators[op]));
  figure_row("refused", static_cast<double>(a.refused), static_cast<double>(b.refused));
  figure_row("pairs", static_cast<double>(a.pairs), static_cast<double>(b.pairs));
  figure_row("height", a.height, b.height);
  figure_row("redundancy", a.redundancy, b.redundancy);
  figure_row("ms, median", a.milliseconds, b.milliseconds);
  ImGui::EndTable();
}

void draw_difference(PanelContext& context, const char* what, const std::optional<std::uint32_t>& step) {
  if (!step) return ImGui::TextDisabled("%s are the same", what);
  ImGui::Text("%s differ first in", what);
  ImGui::SameLine();
  const std::string label = "step " + context.model.run().names().step(*step) + "##" + what;
  const bool pressed = ImGui::SmallButton(label.c_str());
  context.gui.name_last_item(std::string("first different ") + what, label);
  if (pressed) context.model.go(Position::end_of(*step));
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

void draw_compare(PanelContext& context) {
  DebuggerModel& model = context.model;
  if (model.other() == nullptr) {
    ImGui::TextWrapped(
        "%s",
        "Two recordings side by side: the other one goes where this one goes, and its curves lie over these. "
        "\"What if\" makes one, or open one:");
    if (widgets::text_field(context.gui, "other file", context.memory.other_file, "a recording, then Enter",
                            -1))
      open_other(context);
    return;
  }
  if (widgets::button(context.gui, "stop comparing")) return model.stop_comparing();
  ImGui::SameLine();
  if (widgets::button(context.gui, "change over", "go on in the other run")) return model.change_over();
  ImGui::SameLine();
  ImGui::TextDisabled("with %s", model.other()->path().filename().c_str());
  draw_other_moment(model);
  const RecordingComparison& comparison = model.comparison();
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
  draw_figures(comparison.a, comparison.b);
}

}  // namespace kerf
