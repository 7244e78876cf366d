#include "viz/debugger/panels/timeline_rows.h"
#include "viz/draw/palette.h"

namespace kerf {
namespace {

void draw_whole_run(const PanelContext& context, const TimeAxis& whole, float top) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Lane& lane = context.model.lanes()[context.model.timeline.lane];
  const float scale = lane.scale_end(context.model.timeline.clips);
  const float bottom = top + kTimelineRow - 1;
  const auto& columns = lane.columns(whole.scale.window, whole.columns());
  for (std::size_t k = 0; k < columns.size(); ++k) {
    if (columns[k].is_absent() || scale <= 0) continue;
    const float height = std::clamp(columns[k].greatest / scale, 0.0F, 1.0F) * (kTimelineRow - 2);
    list.AddRectFilled({whole.x_of_column(k), bottom - height}, {whole.x_of_column(k + 1), bottom},
                       widgets::to_imgui(palette::kFaintInk, 0.6));
  }
}

/// A press beside the window brings it there; a drag moves it.
void drag_window(PanelContext& context, const TimeAxis& whole, float top) {
  TimeWindow& window = context.model.timeline.window;
  ImGui::SetCursorScreenPos({whole.left, top});
  ImGui::InvisibleButton("minimap", {whole.width(), kTimelineRow});
  context.gui.name_last_item("minimap");
  const ImGuiIO& io = ImGui::GetIO();
  const double time = whole.time_at(io.MousePos.x);
  if (ImGui::IsItemActivated() && (time < window.first() || time > window.last()))
    window.pan(time - window.first() - 0.5 * window.span());
  if (ImGui::IsItemActive()) window.pan(double{io.MouseDelta.x} / whole.scale.pixels_per_step());
  if (ImGui::IsItemHovered() && io.MouseWheel != 0)
    window.zoom(std::pow(kZoomOfWheel, double{io.MouseWheel}), window.first() + 0.5 * window.span(),
                least_span(time, context.model.run().rows()));
}

}  // namespace

void draw_minimap(PanelContext& context, const TimeAxis& axis, float top) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const DebuggerModel& model = context.model;
  TimeAxis whole = axis;
  whole.scale.window.show_all();
  const std::string name = "map: " + std::string(model.lanes()[model.timeline.lane].name());
  draw_row_ground(whole, top, kTimelineRow, name, palette::kFaintInk);
  draw_whole_run(context, whole, top);
  if (const auto& range = model.timeline.range)
    list.AddRectFilled(
        {whole.x_of(range->first - 1.0), top},
        {std::max(whole.x_of(range->first - 1.0) + 2, whole.x_of(range->last)), top + kTimelineRow - 1},
        widgets::to_imgui(palette::kOperator, 0.3));
  const float left = whole.x_of(model.timeline.window.first());
  const float right = std::max(left + 3, whole.x_of(model.timeline.window.last()));
  list.AddRectFilled({left, top}, {right, top + kTimelineRow - 1}, widgets::to_imgui(palette::kMoving, 0.3));
  list.AddRect({left, top}, {right, top + kTimelineRow - 1}, widgets::to_imgui(palette::kPartitioner));
  const float now = whole.x_of(time_of(model.run().position(), model.run().rows()));
  list.AddLine({now, top}, {now, top + kTimelineRow - 1}, widgets::to_imgui(palette::kOperator), 2);
  drag_window(context, whole, top);
}

}  // namespace kerf
