#include "viz/debugger/panels/timeline_rows.h"

namespace kerf {

void draw_timeline_tools(PanelContext& context) {
  DebuggerModel& model = context.model;
  if (widgets::button(context.gui, "-", "show more of the run (-)", "zoom out"))
    model.zoom_lanes(1 / kZoomOfKey);
  ImGui::SameLine();
  if (widgets::button(context.gui, "+", "magnify around this moment (+)", "zoom in"))
    model.zoom_lanes(kZoomOfKey);
  ImGui::SameLine();
  if (widgets::button(context.gui, "whole run", "show all of it (R)")) model.timeline.window.show_all();
}

}  // namespace kerf
