#include "viz/debugger/panels/panel_menu.h"
#include "viz/debugger/panels/timeline_rows.h"

namespace kerf {
namespace {

void draw_zoom(PanelContext& context) {
  DebuggerModel& model = context.model;
  if (widgets::button(context.gui, "-", "show more of the run (-)", "zoom out"))
    model.zoom_lanes(1 / kZoomOfKey);
  ImGui::SameLine();
  if (widgets::button(context.gui, "+", "magnify around this moment (+)", "zoom in"))
    model.zoom_lanes(kZoomOfKey);
  ImGui::SameLine();
  if (widgets::button(context.gui, "whole run", "show all of it (R)")) model.timeline.window.show_all();
}

/// "3 split": the digit is its key.
std::string kind_label(std::size_t k) {
  const std::string key = k < 10 ? std::to_string((k + 1) % 10) : " ";
  return key + " " + std::string(kEventKindNames[k]);
}

void draw_kinds(PanelContext& context) {
  DebuggerModel& model = context.model;
  EventKind& chosen = model.timeline.kind;
  if (widgets::button(context.gui, "<", "back to the previous of this kind (Shift+N, or Shift and its digit)",
                      "previous of kind"))
    model.go_to_kind(chosen, false);
  ImGui::SameLine();
  ImGui::SetNextItemWidth(132);
  const bool open = ImGui::BeginCombo("##kind", kind_label(static_cast<std::size_t>(chosen)).c_str(),
                                      ImGuiComboFlags_HeightLargest);
  context.gui.name_last_item("kind");
  if (open) {
    for (std::size_t k = 0; k < kEventKindNames.size(); ++k) {
      const auto kind = static_cast<EventKind>(k);
      if (widgets::row(context.gui, kind_label(k), "kind " + std::string(to_string(kind)), kind == chosen))
        chosen = kind;
    }
    ImGui::EndCombo();
  }
  ImGui::SameLine();
  if (widgets::button(context.gui, ">", "on to the next of this kind (N, or its digit)", "next of kind"))
    model.go_to_kind(chosen, true);
}

/// The figures of the selected range, beside the buttons or below them.
void draw_figures(PanelContext& context) {
  const DebuggerModel& model = context.model;
  const std::string text =
      to_text(figures_of(*model.timeline.range, model.run().rows(), model.lanes()), model.run().names());
  widgets::beside_or_below(ImGui::CalcTextSize(text.c_str()).x + kMenuRoom);
  const std::string shown = widgets::elided(text, ImGui::GetContentRegionAvail().x - kMenuRoom);
  ImGui::TextUnformatted(shown.c_str());
  context.gui.note_last_item("range figures");
  if (shown != text) widgets::hint(text.c_str());
}

void draw_range_tools(PanelContext& context) {
  DebuggerModel& model = context.model;
  if (!model.timeline.range) {
    const float room = ImGui::GetContentRegionAvail().x - kMenuRoom;
    ImGui::TextDisabled("%s", widgets::elided("Shift and a drag, or S and E: select steps", room).c_str());
    return;
  }
  bool loops = model.timeline.loops;
  if (widgets::checkbox(context.gui, "loop", loops, "play the range over and over (L)")) model.toggle_loop();
  ImGui::SameLine();
  if (widgets::button(context.gui, "show range", "magnify it; again: the whole run (R)")) model.show_range();
  ImGui::SameLine();
  const bool drops = widgets::button(context.gui, "x", "select no range (Esc)", "drop range");
  draw_figures(context);
  if (drops) model.drop_range();
}

}  // namespace

void draw_timeline_tools(PanelContext& context) {
  draw_zoom(context);
  ImGui::SameLine(0, 18);
  draw_kinds(context);
  ImGui::SameLine(0, 18);
  draw_range_tools(context);
}

}  // namespace kerf
