#include "core/query/text.h"
#include "viz/debugger/panels/timeline_rows.h"
#include "viz/draw/palette.h"

namespace kerf {
namespace {

/// What the lanes say about the moment under the mouse.
void show_moment(const DebuggerModel& model, const TimeAxis& axis, const Position& there) {
  const GivenNames& names = model.run().names();
  std::string text = "step " + names.step(there.step);
  if (!there.is_end())
    for (const Event& event : model.run().events_of(there.step))
      if (event.id == there.event) text = describe(event, names);
  for (const Lane& lane : model.lanes()) {
    const auto value = lane.value(there.step);
    text += "\n" + std::string(lane.name()) + " " +
            (value ? number_text(std::round(*value * 1000) / 1000) : std::string("-"));
  }
  text += words_of_marks(model, axis, ImGui::GetIO().MousePos.x);
  // Above the lanes, on the side that has more room.
  const float x = ImGui::GetIO().MousePos.x;
  const bool is_left = x < 0.5F * ImGui::GetIO().DisplaySize.x;
  ImGui::SetNextWindowPos({x, ImGui::GetWindowPos().y - 2}, ImGuiCond_Always, {is_left ? 0.0F : 1.0F, 1});
  ImGui::SetTooltip("%s", text.c_str());
}

/// The wheel zooms at the mouse; with Shift, or sideways, it pans.
void turn_wheel(TimeWindow& window, const TimeAxis& axis, std::span<const StepRow> rows) {
  const ImGuiIO& io = ImGui::GetIO();
  const double time = axis.time_at(io.MousePos.x);
  const double sideways = double{io.MouseWheelH} + (io.KeyShift ? double{io.MouseWheel} : 0);
  if (sideways != 0) window.pan(-kPanOfWheel * sideways * window.span());
  if (!io.KeyShift && io.MouseWheel != 0)
    window.zoom(std::pow(kZoomOfWheel, double{io.MouseWheel}), time, least_span(time, rows));
}

/// A drag with Shift selects the steps between its ends; a press without a drag selects one.
void select_range(PanelContext& context, double time) {
  DebuggerModel& model = context.model;
  if (ImGui::IsItemActivated()) context.memory.range_from = time;
  if (context.memory.range_from && model.run().steps() > 0)
    model.timeline.range = steps_between(*context.memory.range_from, time, model.run().steps());
}

/// The selected range over the rows.
void draw_range(const DebuggerModel& model, const TimeAxis& axis, float top, float bottom) {
  if (!model.timeline.range) return;
  const float left = std::max(axis.left, axis.x_of(model.timeline.range->first - 1.0));
  const float right = std::min(axis.right(), axis.x_of(model.timeline.range->last));
  if (left >= right) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({left, top}, {right, bottom}, widgets::to_imgui(palette::kOperator, 0.1));
  list.AddRect({left, top}, {right, bottom}, widgets::to_imgui(palette::kOperator, 0.5));
}

/// Over the lanes a left drag moves the cursor or, with Shift, selects; a right or middle drag pans.
void use_lanes(PanelContext& context, const TimeAxis& axis, float top, float bottom) {
  constexpr auto kButtons = ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                            ImGuiButtonFlags_MouseButtonMiddle;
  ImGui::SetCursorScreenPos({axis.left, top});
  ImGui::InvisibleButton("scrubber", {axis.width(), bottom - top}, kButtons);
  context.gui.name_last_item("scrubber");
  DebuggerModel& model = context.model;
  const ImGuiIO& io = ImGui::GetIO();
  const auto rows = model.run().rows();
  if (ImGui::IsItemHovered()) turn_wheel(model.timeline.window, axis, rows);
  const bool pans = io.MouseDown[1] || io.MouseDown[2];
  const double time =
      std::clamp(axis.time_at(io.MousePos.x), axis.scale.window.first(), axis.scale.window.last());
  const Position there = moment_at(time, axis.scale.pixels_per_step(), rows);
  if (ImGui::IsItemActive() && pans)
    model.timeline.window.pan(-double{io.MouseDelta.x} / axis.scale.pixels_per_step());
  if (!io.MouseDown[0]) context.memory.range_from.reset();
  const bool selects = io.KeyShift || context.memory.range_from;
  if (ImGui::IsItemActive() && !pans && selects) select_range(context, time);
  if (ImGui::IsItemActive() && !pans && !selects) model.go(there);
  if (ImGui::IsItemHovered() || ImGui::IsItemActive()) show_moment(model, axis, there);
}

}  // namespace

void draw_timeline(PanelContext& context) {
  draw_timeline_tools(context);
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const DebuggerModel& model = context.model;
  const float width = std::floor(std::max(50.0F, room.x - kTimelineNames - 3 * kTimelineValue - 4));
  const TimeAxis axis{origin.x + kTimelineNames, {model.timeline.window, double{width}}, context.gui.scale()};
  const float lanes = room.y - 5 * kTimelineRow - 4;
  const float y = origin.y + kTimelineRow + draw_lanes(context, axis, origin.y + kTimelineRow, lanes) + 1;
  draw_event_row_of_time(context, axis, y);
  draw_marks(context, axis, y + kTimelineRow);
  draw_ribbons(context, axis, y + 2 * kTimelineRow);
  const float end_of_rows = y + 3 * kTimelineRow - 1;
  draw_time_ruler(context, axis, origin.y - 1, end_of_rows);
  draw_range(model, axis, origin.y + kTimelineRow - 3, end_of_rows);
  const double now = time_of(model.run().position(), model.run().rows());
  const float x = axis.x_of(now);
  if (axis.has(now))
    ImGui::GetWindowDrawList()->AddLine({x, origin.y + kTimelineRow - 4}, {x, end_of_rows},
                                        widgets::to_imgui(palette::kOperator), 2);
  use_lanes(context, axis, origin.y, end_of_rows);
  draw_minimap(context, axis, end_of_rows + 3);
}

}  // namespace kerf
