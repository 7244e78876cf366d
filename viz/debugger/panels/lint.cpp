#include <cmath>

#include "viz/debugger/gui/widgets.h"
#include "viz/debugger/panels/panel.h"

namespace kerf {

namespace {

void draw_fault(PanelContext& context, const TheirFault& fault, std::size_t k) {
  DebuggerModel& model = context.model;
  if (!widgets::row(context.gui, to_text(fault, model.run().names()), "fault " + std::to_string(k), false))
    return;
  model.go(Position::end_of(fault.first_step));
  model.select(fault.fault.object.is_none() ? Selection() : Selection(fault.fault.object));
}

/// Of another engine, while its structure is shown.
void draw_faults(PanelContext& context) {
  const auto faults = context.model.run().all_their_faults();
  ImGui::TextWrapped("%s", "What is wrong with the other engine's structure:");
  ImGui::SameLine();
  ImGui::TextDisabled("%zu found", faults.size());
  ImGui::BeginChild("findings", {0, 0}, true);
  if (faults.empty()) ImGui::TextWrapped("%s", "It is sound in all steps in which it is known.");
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(faults.size()));
  while (clipper.Step())
    for (int k = clipper.DisplayStart; k < clipper.DisplayEnd; ++k)
      draw_fault(context, faults[static_cast<std::size_t>(k)], static_cast<std::size_t>(k));
  ImGui::EndChild();
}

}  // namespace

void draw_lint(PanelContext& context) {
  DebuggerModel& model = context.model;
  if (model.view.theirs) return draw_faults(context);
  ImGui::TextWrapped("%s", "Operators that undo each other, or wait:");
  auto within = static_cast<float>(context.memory.lint_within);
  if (widgets::slider(context.gui, "within", within, {5, 500, true}, "within %.0f steps", 120))
    context.memory.lint_within = static_cast<int>(std::lround(within));
  const std::vector<Thrash>& found = model.lint(static_cast<std::uint32_t>(context.memory.lint_within));
  ImGui::SameLine();
  ImGui::TextDisabled("%zu found", found.size());
  ImGui::BeginChild("findings", {0, 0}, true);
  if (found.empty())
    ImGui::TextWrapped(
        "%s", "Nothing is split, merged and split again, no partitioner goes to and fro, nothing waits.");
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(found.size()));
  while (clipper.Step())
    for (int k = clipper.DisplayStart; k < clipper.DisplayEnd; ++k) {
      const Thrash& thrash = found[static_cast<std::size_t>(k)];
      const std::string id = "e" + std::to_string(thrash.event);
      if (!widgets::row(context.gui, id + "  " + to_text(thrash, model.run().names()),
                        "finding " + std::to_string(k), false))
        continue;
      model.select(thrash.node);
      model.go_to_event(thrash.event);
    }
  ImGui::EndChild();
}

}  // namespace kerf
