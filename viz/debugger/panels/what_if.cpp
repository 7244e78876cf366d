
#include "core/trace/event_facts.h"
#include "viz/debugger/gui/widgets.h"
#include "viz/debugger/panels/panel.h"
#include "viz/draw/palette.h"

namespace kerf {
namespace {

void ask(PanelContext& context, const WhatIfQuestion& question) {
  try {
    context.model.what_if(question);
    context.memory.open_tab = "Compare";
    context.memory.problem_of_what_if.clear();
  } catch (const std::exception& error) {
    context.memory.problem_of_what_if = error.what();
  }
}

void draw_decisions(PanelContext& context) {
  DebuggerModel& model = context.model;
  const auto event = model.run().event();
  if (!event || !is_outcome(*event)) {
    ImGui::TextDisabled("go to an operator to refuse it, or to take\nanother candidate");
    return;
  }
  const std::string id = "e" + std::to_string(event->id);
  if (widgets::button(context.gui, ("refuse " + id).c_str(), "the operator does not act", "refuse"))
    ask(context, {.event = event->id});
  const std::size_t count = model.run().ballot().size();
  if (count == 0) return;
  ImGui::SameLine();
  const std::size_t k =
      std::min(model.hovered_candidate.value_or(context.memory.kept_candidate.value_or(0)), count - 1);
  if (widgets::button(context.gui, ("take candidate " + std::to_string(k)).c_str(),
                      "press a candidate in the ballot to choose it", "take candidate"))
    ask(context, {.event = event->id, .candidate = k});
}

/// All parameters with their present values; a click puts one into the field.
void draw_parameters(PanelContext& context) {
  const Config& config = context.model.run().config();
  ImGui::BeginChild("parameters", {0, 0}, true);
  for (const ConfigField& field : config_fields()) {
    const std::string name(field.name);
    const std::string line = name + "=" + get(config, field.name);
    if (widgets::row(context.gui, line, "parameter " + name, false)) context.memory.assignments = line;
    if (ImGui::IsItemHovered())
      ImGui::SetTooltip("%s\n%g to %g", field.meaning.data(), field.minimum, field.maximum);
  }
  ImGui::EndChild();
}

}  // namespace

void draw_what_if(PanelContext& context) {
  DebuggerModel& model = context.model;
  PanelMemory& memory = context.memory;
  ImGui::TextWrapped(
      "%s", "The same boxes again, with something else decided; the new run is compared with this one.");
  draw_decisions(context);
  const Position& now = model.run().position();
  const std::uint32_t from = now.step + 1;
  ImGui::Text("from %s on", model.run().names().coming_step(from).c_str());
  ImGui::SameLine();
  const bool entered =
      widgets::text_field(context.gui, "assignments", memory.assignments, "min_balance=0.3", -60);
  ImGui::SameLine();
  const bool pressed = widgets::button(context.gui, "run", "run on with this parameter", "run what if");
  if ((entered || pressed) && !memory.assignments.empty())
    ask(context, {.assignments = memory.assignments, .from = from});
  if (!memory.problem_of_what_if.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, widgets::to_vector(palette::kCandidate));
    ImGui::TextWrapped("%s", memory.problem_of_what_if.c_str());
    ImGui::PopStyleColor();
  }
  draw_parameters(context);
}

}  // namespace kerf
