#include <algorithm>
#include <cmath>

#include "core/base/counted.h"
#include "core/query/text.h"
#include "viz/debugger/gui/widgets.h"
#include "viz/debugger/panels/panel.h"
#include "viz/draw/palette.h"

namespace kerf {
namespace {

constexpr float kNames = 108;  // width of the lanes' names
constexpr float kValues = 76;  // and of their values at this moment
constexpr float kMarks = 14;   // height of the row of marks

/// Steps from 0 to the last, spread over the width of the lanes.
struct TimeAxis {
  float left = 0;
  float width = 1;
  std::uint32_t steps = 1;

  [[nodiscard]] float x_of(double step) const {
    return left + static_cast<float>(step / std::max(1U, steps)) * width;
  }
  [[nodiscard]] std::uint32_t step_at(float x) const {
    const double share = std::clamp(double{(x - left) / width}, 0.0, 1.0);
    return static_cast<std::uint32_t>(std::lround(share * steps));
  }
};

void draw_curve(ImDrawList& list, const Lane& lane, float scale, const TimeAxis& axis, float top,
                float height, ImU32 color, bool filled) {
  const auto columns = columns_of(lane, static_cast<std::size_t>(std::max(1.0F, axis.width)));
  const auto y_of = [&](float value) {
    return top + height - 1 - (scale > 0 ? value / scale : 0) * (height - 3);
  };
  const auto same = [&](std::size_t a, std::size_t b) {
    return columns[a].least == columns[b].least && columns[a].greatest == columns[b].greatest;
  };
  // Neighbours of the same height are one rectangle: there are thousands of columns.
  for (std::size_t k = 0, end = 0; k < columns.size(); k = end) {
    for (end = k + 1; end < columns.size() && same(k, end);) ++end;
    const float high = y_of(columns[k].greatest);
    const float low = filled ? top + height - 1 : std::max(y_of(columns[k].least), high + 1.5F);
    if (filled && columns[k].greatest <= 0) continue;
    list.AddRectFilled({axis.left + static_cast<float>(k), high}, {axis.left + static_cast<float>(end), low},
                       color);
  }
}

float value_at(const Lane& lane, std::uint32_t step) {
  return step == 0 || step > lane.values.size() ? 0 : lane.values[step - 1];
}

void draw_lane(PanelContext& context, std::size_t k, const TimeAxis& axis, float top, float height) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Lane& lane = context.model.lanes()[k];
  const Color color = palette::kSeries[k % 6];
  const float left = ImGui::GetWindowPos().x + 8;
  list.AddRectFilled({axis.left, top}, {axis.left + axis.width, top + height - 2},
                     IM_COL32(255, 255, 255, 255));
  list.AddText({left, top + 0.5F * (height - 15)}, widgets::to_imgui(palette::kInk), lane.name.data());
  float scale = lane.largest;
  const Run* const other = context.model.other();
  if (other != nullptr) scale = std::max(scale, context.model.other_lanes()[k].largest);
  TimeAxis columns = axis;
  draw_curve(list, lane, scale, columns, top, height,
             widgets::to_imgui(color, other == nullptr ? 0.75 : 0.45), true);
  if (other != nullptr) {
    columns.width =
        axis.width * static_cast<float>(other->steps()) / static_cast<float>(std::max(1U, axis.steps));
    columns.width = std::min(columns.width, axis.width);
    draw_curve(list, context.model.other_lanes()[k], scale, columns, top, height,
               widgets::to_imgui(palette::kInk), false);
  }
  const float value = value_at(lane, context.model.run().position().step);
  const std::string text = number_text(std::round(double{value} * 1000) / 1000);
  list.AddText({axis.left + axis.width + 6, top + 0.5F * (height - 15)}, widgets::to_imgui(palette::kInk),
               text.c_str());
}

/// The oracle's verdicts, the operators at the selected node, and bookmarks.
void draw_marks(PanelContext& context, const TimeAxis& axis, float top) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  DebuggerModel& model = context.model;
  list.AddText({ImGui::GetWindowPos().x + 8, top - 1}, widgets::to_imgui(palette::kInk), "oracle, marks");
  list.AddRectFilled({axis.left, top}, {axis.left + axis.width, top + kMarks - 2},
                     IM_COL32(255, 255, 255, 255));
  const float width = std::max(1.5F, axis.width / static_cast<float>(std::max(1U, axis.steps)));
  std::size_t wrong = 0;
  for (const auto& alarm : model.alarms()) {
    if (!alarm || alarm->step == 0) continue;
    wrong += alarm->is_wrong() ? 1 : 0;
    const float x = axis.x_of(alarm->step);
    const Color color = alarm->is_wrong() ? palette::kCandidate : palette::kSeries[2];
    list.AddRectFilled({x - width, top + (alarm->is_wrong() ? 0.0F : 4.0F)}, {x, top + kMarks - 2},
                       widgets::to_imgui(color, alarm->is_wrong() ? 1 : 0.5));
  }
  for (const Position& mark : model.bookmarks()) {
    const float x = axis.x_of(mark.step);
    list.AddTriangleFilled({x - 5, top}, {x + 5, top}, {x, top + 9}, widgets::to_imgui(palette::kOperator));
  }
  const std::string text = wrong == 0 ? "no alarm" : counted(wrong, "alarm");
  list.AddText({axis.left + axis.width + 6, top - 1},
               widgets::to_imgui(wrong == 0 ? palette::kFaintInk : palette::kCandidate), text.c_str());
}

/// The look of a ribbon: the share of the row that it leaves free above and below, and its colour.
struct RibbonLook {
  float margin;
  Color color;
  double alpha;
};
RibbonLook look_of(Ribbon::Kind kind) {
  switch (kind) {
    case Ribbon::Kind::life:
      return {0.3F, palette::kSeries[4], 0.5};
    case Ribbon::Kind::divided:
      return {0.1F, palette::kSeries[4], 0.7};
    case Ribbon::Kind::listed:
      return {0.3F, palette::kFaintInk, 1};
    case Ribbon::Kind::acted:
      return {0, palette::kInk, 1};
    case Ribbon::Kind::refused:
      return {0, palette::kCandidate, 1};
    case Ribbon::Kind::pair:
      return {0, palette::kSeries[4], 1};
  }
  return {0, palette::kInk, 1};
}

/// The lives of the selected node, thin as a leaf and thick with children, and the operators at it; or the
/// times when the selected objects were a pair.
void draw_ribbons(PanelContext& context, const TimeAxis& axis, float top) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const bool nothing = is_nothing(context.model.selection());
  const std::string name =
      nothing ? "selected" : to_string(context.model.selection(), context.model.run().names());
  list.AddText({ImGui::GetWindowPos().x + 8, top - 1},
               widgets::to_imgui(nothing ? palette::kFaintInk : palette::kInk), name.c_str());
  list.AddRectFilled({axis.left, top}, {axis.left + axis.width, top + kMarks - 2},
                     IM_COL32(255, 255, 255, 255));
  for (const Ribbon& ribbon : context.model.ribbons()) {
    const RibbonLook look = look_of(ribbon.kind);
    const float left = axis.x_of(std::max(0.0, ribbon.first_step - 1.0));
    const float right = std::max(left + 2, axis.x_of(ribbon.last_step));
    const float margin = 1 + std::round(look.margin * (kMarks - 4));
    list.AddRectFilled({left, top + margin}, {right, top + kMarks - 2 - margin},
                       widgets::to_imgui(look.color, look.alpha));
  }
}

/// A press or drag anywhere over the lanes moves the cursor there.
void scrub(PanelContext& context, const TimeAxis& axis, float top, float bottom) {
  ImGui::SetCursorScreenPos({axis.left, top});
  ImGui::InvisibleButton("scrubber", {axis.width, bottom - top});
  context.gui.name_last_item("scrubber");
  const std::uint32_t step = axis.step_at(ImGui::GetIO().MousePos.x);
  if (ImGui::IsItemActive() && context.model.run().position() != Position::end_of(step))
    context.model.go(Position::end_of(step));
  if (!ImGui::IsItemHovered() && !ImGui::IsItemActive()) return;
  std::string text = "step " + context.model.run().names().step(step);
  for (const Lane& lane : context.model.lanes())
    text += "\n" + std::string(lane.name) + " " +
            number_text(std::round(double{value_at(lane, step)} * 1000) / 1000);
  ImGui::SetTooltip("%s", text.c_str());
}

}  // namespace

void draw_timeline(PanelContext& context) {
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const DebuggerModel& model = context.model;
  const TimeAxis axis{origin.x + kNames, std::max(50.0F, room.x - kNames - kValues), model.run().steps()};
  const float lanes = room.y - 2 * kMarks - 4;
  const float height = lanes / static_cast<float>(model.lanes().size());
  for (std::size_t k = 0; k < model.lanes().size(); ++k)
    draw_lane(context, k, axis, origin.y + height * static_cast<float>(k), height);
  draw_marks(context, axis, origin.y + lanes + 2);
  draw_ribbons(context, axis, origin.y + lanes + kMarks + 4);
  const float x = axis.x_of(model.run().position().step);
  ImGui::GetWindowDrawList()->AddLine({x, origin.y}, {x, origin.y + room.y},
                                      widgets::to_imgui(palette::kOperator), 2);
  scrub(context, axis, origin.y, origin.y + room.y);
}

}  // namespace kerf
