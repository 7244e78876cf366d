#include "core/base/counted.h"
#include "core/query/text.h"
#include "viz/debugger/panels/timeline_rows.h"
#include "viz/draw/palette.h"

namespace kerf {
namespace {

constexpr float kLetterHeight = 15;

/// A value in at most seven letters.
std::string short_value(const std::optional<double>& value) {
  if (!value) return "-";
  if (std::abs(*value) >= 1e6) return number_text(*value / 1e6, 4) + "M";
  if (std::abs(*value) >= 1e5) return number_text(*value / 1e3, 4) + "k";
  if (*value != 0 && std::abs(*value) < 1e-3) return number_text(*value, 2);
  return number_text(std::round(*value * 1000) / 1000, 5);
}

/// Where a lane's values are, in units of the panels.
struct LaneBand {
  float top = 0;
  float height = 0;
  float scale = 0;  ///< the value at its upper end
  [[nodiscard]] float bottom() const { return top + height - 1; }
  [[nodiscard]] float y_of(float value) const {
    const float share = scale > 0 ? std::clamp(value / scale, 0.0F, 1.0F) : 0;
    return bottom() - share * (height - 3);
  }
};

void draw_curve(const Lane& lane, const LaneBand& band, const TimeAxis& axis, ImU32 color, bool filled) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const std::vector<LaneRange>& columns = lane.columns(axis.scale.window, axis.columns());
  for (std::size_t k = 0, end = 0; k < columns.size(); k = end) {
    for (end = k + 1; end < columns.size() && columns[k] == columns[end];) ++end;
    if (columns[k].is_absent() || (filled && columns[k].greatest <= 0)) continue;
    const float left = axis.x_of_column(k);
    const float right = axis.x_of_column(end);
    const float high = band.y_of(columns[k].greatest);
    const float low = filled ? band.bottom() : std::max(band.y_of(columns[k].least), high + 1.5F);
    list.AddRectFilled({left, high}, {right, low}, color);
    // A value beyond the scale has a cap.
    if (columns[k].greatest > band.scale)
      list.AddRectFilled({left, band.top}, {right, band.top + 2}, widgets::to_imgui(palette::kCandidate));
  }
}

/// A small arrow at an extreme value.
void draw_extreme_mark(const TimeAxis& axis, const LaneBand& band, std::uint32_t step, bool greatest) {
  const double time = step - 0.5;
  if (step == 0 || !axis.has(time)) return;
  const float x = axis.x_of(time);
  const float y = greatest ? band.top : band.bottom();
  const float up = greatest ? 4.0F : -4.0F;
  ImGui::GetWindowDrawList()->AddTriangleFilled({x - 4, y}, {x + 4, y}, {x, y + up},
                                                widgets::to_imgui(palette::kInk));
}

/// A text that can be pressed. `area` is its whole cell.
bool text_button(PanelContext& context, const PanelArea& area, const std::string& text,
                 const std::string& name, Color ink, const std::string& hint) {
  ImGui::SetCursorScreenPos({area.x, area.y});
  const bool pressed = ImGui::InvisibleButton(name.c_str(), {area.width, area.height});
  context.gui.name_last_item(name, text);
  const float y = area.y + 0.5F * (area.height - kLetterHeight);
  if (ImGui::IsItemHovered()) ink = palette::kOperator;
  ImGui::GetWindowDrawList()->AddText({area.x, y}, widgets::ink(ink), text.c_str());
  widgets::hint(hint.c_str());
  return pressed;
}

void draw_name(PanelContext& context, std::size_t k, const LaneBand& band) {
  Timeline& timeline = context.model.timeline;
  const Lane& lane = context.model.lanes()[k];
  const std::string name(lane.name());
  const float left = ImGui::GetWindowPos().x + 8;
  const float wide = ImGui::CalcTextSize(name.c_str()).x;
  if (text_button(context, {left, band.top, wide, band.height - 1}, name, "lane " + name,
                  timeline.lane == k ? palette::kOperator : palette::kInk,
                  "choose this lane: M goes to its maximum, Shift+M to its minimum, the map shows it"))
    timeline.lane = k;
  if (lane.above() == 0) return;
  const std::string above = std::to_string(lane.above()) + " above p99";
  const float width = ImGui::CalcTextSize(above.c_str()).x;
  const std::string hint = "The scale ends at the 99th percentile, " +
                           number_text(double{lane.scale_end(true)}) + "; " +
                           counted(lane.above(), "step is", "steps are") +
                           " above it and have a cap.\nPress: scales end at the maximum (C)";
  const std::string full = "to maximum";
  const std::string& shown = timeline.clips ? above : full;
  if (text_button(context, {left + kTimelineNames - 16 - width, band.top, width, band.height - 1}, shown,
                  "clip " + name, palette::kCandidate, hint))
    timeline.clips = !timeline.clips;
}

void draw_values(PanelContext& context, std::size_t k, const TimeAxis& axis, const LaneBand& band) {
  DebuggerModel& model = context.model;
  const Lane& lane = model.lanes()[k];
  const std::string name(lane.name());
  float x = axis.right() + 6;
  const std::string now = short_value(lane.value(model.run().position().step));
  ImGui::GetWindowDrawList()->AddText({x, band.top + 0.5F * (band.height - 1 - kLetterHeight)},
                                      widgets::ink(palette::kInk), now.c_str());
  for (const bool greatest : {false, true}) {
    x += kTimelineValue;
    const std::uint32_t step = greatest ? lane.greatest_step() : lane.least_step();
    const std::string word = greatest ? "max" : "min";
    const std::string text = short_value(lane.value(step));
    const std::string hint =
        step == 0 ? "" : "first at step " + model.run().names().step(step) + ": go there";
    if (!text_button(context, {x, band.top, kTimelineValue - 4, band.height - 1}, text, word + " " + name,
                     palette::kPartitioner, hint))
      continue;
    model.timeline.lane = k;
    model.go_to_extreme(greatest);
  }
}

void draw_lane(PanelContext& context, std::size_t k, const TimeAxis& axis, LaneBand band) {
  DebuggerModel& model = context.model;
  const Lane& lane = model.lanes()[k];
  const bool clips = model.timeline.clips;
  const bool compares = model.other() != nullptr && k < model.other_lanes().size();
  const Lane* const other = compares ? &model.other_lanes()[k] : nullptr;
  band.scale = lane.scale_end(clips);
  if (other != nullptr) band.scale = std::max(band.scale, other->scale_end(clips));
  ImGui::GetWindowDrawList()->AddRectFilled({axis.left, band.top}, {axis.right(), band.bottom()},
                                            widgets::to_imgui(widgets::theme().paper));
  const ImU32 color = widgets::to_imgui(palette::kLanes[k % palette::kLanes.size()]);
  draw_curve(lane, band, axis, color, true);
  if (other != nullptr) draw_curve(*other, band, axis, widgets::to_imgui(palette::kInk), false);
  if (lane.greatest_step() != lane.least_step()) {
    draw_extreme_mark(axis, band, lane.greatest_step(), true);
    draw_extreme_mark(axis, band, lane.least_step(), false);
  }
  draw_name(context, k, band);
  draw_values(context, k, axis, band);
}

}  // namespace

float draw_lanes(PanelContext& context, const TimeAxis& axis, float top, float height) {
  const std::size_t count = context.model.lanes().size();
  const float each = std::floor(height / static_cast<float>(count));
  for (std::size_t k = 0; k < count; ++k)
    draw_lane(context, k, axis, {top + each * static_cast<float>(k), each, 0});
  return each * static_cast<float>(count);
}

}  // namespace kerf
