#include "viz/debugger/panels/timeline_rows.h"

#include "core/base/counted.h"
#include "core/trace/event_facts.h"
#include "viz/debugger/model/event_kinds.h"
#include "viz/draw/palette.h"

namespace kerf {
namespace {

constexpr float kMark = 5;  // half the width of a bookmark

/// The look of a ribbon: the share of the row that it leaves free above and below, and its colour.
struct RibbonLook {
  float margin;
  Color color;
  double alpha;
};
RibbonLook look_of(Ribbon::Kind kind) {
  switch (kind) {
    case Ribbon::Kind::life:
      return {0.3F, palette::kSelected, 0.75};
    case Ribbon::Kind::divided:
      return {0.1F, palette::kSelected, 1};
    case Ribbon::Kind::listed:
      return {0.3F, palette::kFaintInk, 1};
    case Ribbon::Kind::acted:
      return {0, palette::kInk, 1};
    case Ribbon::Kind::refused:
      return {0, palette::kCandidate, 1};
    case Ribbon::Kind::pair:
      return {0, palette::kSelected, 1};
  }
  return {0, palette::kInk, 1};
}

/// Operators of a kind that acted in a stretch of steps.
std::uint64_t count_acted(std::span<const StepRow> rows, const TimeWindow::Column& steps, std::size_t op) {
  if (steps.last > rows.size()) return 0;
  const std::uint64_t before = steps.before == 0 ? 0 : rows[steps.before - 1].statistics.operators[op];
  return rows[steps.last - 1].statistics.operators[op] - before;
}

bool events_are_seen(const TimeAxis& axis, std::span<const StepRow> rows, std::uint32_t step) {
  return step <= rows.size() && events_are_apart(axis.scale.pixels_per_step(), rows[step - 1].events);
}

Color color_of_kind(EventKind kind) {
  if (kind <= EventKind::merge) return palette::kLanes[static_cast<std::size_t>(kind)];
  return kind == EventKind::refused ? palette::kCandidate : palette::kFaintInk;
}

/// "e17 split", "e18 phase sweep"
std::string event_label(const Event& event) {
  const auto phase = phase_of(event);
  const std::string_view kind = to_string(kind_of_event(event));
  return "e" + std::to_string(event.id) + " " + std::string(kind) +
         (phase ? " " + std::string(to_string(*phase)) : "");
}

/// Each event of a step as a line, with its id and what it is where there is room.
void draw_events_of_step(PanelContext& context, const TimeAxis& axis, const StepRow& row, float top) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const double part = 1 / (static_cast<double>(row.events) + 1);
  const auto room = static_cast<float>(part * axis.scale.pixels_per_step());
  for (const Event& event : context.model.run().events_of(row.step)) {
    const double time = row.step - 1 + part * (static_cast<double>(event.id - row.first_event) + 1);
    if (!axis.has(time)) continue;
    const float x = axis.x_of(time);
    const EventKind kind = kind_of_event(event);
    list.AddRectFilled({x - 1, top + (is_outcome(event) ? 0.0F : 5.0F)}, {x + 1, top + kTimelineRow - 1},
                       widgets::to_imgui(color_of_kind(kind)));
    for (const std::string& text : {event_label(event), "e" + std::to_string(event.id)}) {
      const float width = ImGui::CalcTextSize(text.c_str()).x;
      if (width + 10 > room || x + 4 + width > axis.right()) continue;
      list.AddText({x + 4, top - 1}, widgets::ink(palette::kInk), text.c_str());
      break;
    }
  }
}

/// 2: a step with a wrong pair, 1: steps about which the oracle was asked, 0: none of them.
int judged(const DebuggerModel& model, const TimeWindow::Column& steps) {
  const auto within = [&](auto found, auto end, auto step_of) {
    return found != end && step_of(*found) <= steps.last;
  };
  const auto& wrong = model.wrong_steps();
  if (within(wrong.upper_bound(steps.before), wrong.end(), [](std::uint32_t step) { return step; })) return 2;
  const auto& asked = model.alarms();
  return within(asked.upper_bound(steps.before), asked.end(), [](const auto& item) { return item.first; })
             ? 1
             : 0;
}

/// Keeps labels from overlapping: each is placed only if it has room beside the one before it.
class RulerLabels {
 public:
  RulerLabels(const TimeAxis& axis, float top) : axis_(axis), top_(top) {}
  void place(float x, const std::string& text, Color ink) {
    constexpr float kApart = 10;
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    const float left = std::clamp(x - 0.5F * width, axis_.left, std::max(axis_.left, axis_.right() - width));
    if (left < free_ || left + width > axis_.right()) return;
    ImGui::GetWindowDrawList()->AddText({left, top_}, widgets::ink(ink), text.c_str());
    free_ = left + width + kApart;
  }

 private:
  const TimeAxis& axis_;
  float top_;
  float free_ = 0;
};

}  // namespace

void draw_row_ground(const TimeAxis& axis, float top, float height, const std::string& name, Color ink) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddText({ImGui::GetWindowPos().x + 8, top - 1}, widgets::ink(ink), name.c_str());
  list.AddRectFilled({axis.left, top}, {axis.right(), top + height - 1},
                     widgets::to_imgui(widgets::theme().paper));
}

void draw_time_ruler(PanelContext& context, const TimeAxis& axis, float top, float bottom) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Run& run = context.model.run();
  const GivenNames& names = run.names();
  list.AddText({ImGui::GetWindowPos().x + 8, top}, widgets::ink(palette::kFaintInk), "step");
  float x = axis.right() + 6;
  for (const char* const heading : {"now", "min", "max"}) {
    list.AddText({x, top}, widgets::ink(palette::kFaintInk), heading);
    x += kTimelineValue;
  }
  const std::size_t letters = std::max(names.step(1).size(), names.step(run.steps()).size());
  const float wide = ImGui::CalcTextSize("m").x * static_cast<float>(letters) + 24;
  RulerLabels labels(axis, top);
  const auto steps = axis_steps(axis.scale.window, static_cast<std::size_t>(axis.width() / wide), names);
  if (steps.empty()) {
    const auto step = static_cast<std::uint32_t>(axis.scale.window.last()) + 1;
    labels.place(axis.left + 0.5F * axis.width(), "within step " + names.step(step), palette::kInk);
  }
  for (const std::uint32_t step : steps) {
    if (step > run.steps()) break;
    const float tick = axis.x_of(step);
    list.AddLine({tick, top + kTimelineRow - 3}, {tick, bottom}, widgets::to_imgui(palette::kFaintInk, 0.25));
    labels.place(tick, names.step(step), palette::kInk);
  }
}

void draw_event_row_of_time(PanelContext& context, const TimeAxis& axis, float top) {
  draw_row_ground(axis, top, kTimelineRow, "operators by kind", palette::kInk);
  const auto rows = context.model.run().rows();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  constexpr float kLine = (kTimelineRow - 1) / kOperatorCount;
  for (std::size_t op = 0; op < kOperatorCount; ++op) {
    const Color color = color_of_kind(kind_of(static_cast<Operator>(op)));
    const float y = top + kLine * static_cast<float>(op);
    for_each_stretch(
        axis,
        [&](const TimeWindow::Column& steps) {
          return !events_are_seen(axis, rows, steps.last) && count_acted(rows, steps, op) > 0 ? 1 : 0;
        },
        [&](float left, float right, int /*value*/) {
          list.AddRectFilled({left, y}, {std::max(right, left + 1), y + kLine}, widgets::to_imgui(color));
        });
  }
  if (!events_are_apart(axis.scale.pixels_per_step(), 0)) return;
  const auto first = static_cast<std::uint32_t>(axis.scale.window.first());
  for (std::uint32_t step = first + 1; step - 1 < axis.scale.window.last(); ++step)
    if (events_are_seen(axis, rows, step)) draw_events_of_step(context, axis, rows[step - 1], top);
}

void draw_marks(PanelContext& context, const TimeAxis& axis, float top) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  DebuggerModel& model = context.model;
  draw_row_ground(axis, top, kTimelineRow, "oracle, marks", palette::kInk);
  for_each_stretch(
      axis, [&](const TimeWindow::Column& steps) { return judged(model, steps); },
      [&](float left, float right, int value) {
        const bool is_wrong = value == 2;
        list.AddRectFilled({left, top + (is_wrong ? 0.0F : 4.0F)},
                           {std::max(right, left + 1.5F), top + kTimelineRow - 1},
                           widgets::to_imgui(is_wrong ? palette::kCandidate : palette::kSeries[2]));
      });
  for (const auto& [mark, note] : model.bookmarks) {
    const double time = time_of(mark, model.run().rows());
    if (!axis.has(time)) continue;
    const float x = axis.x_of(time);
    list.AddTriangleFilled({x - kMark, top}, {x + kMark, top}, {x, top + 9},
                           widgets::to_imgui(palette::kOperator));
  }
  const std::size_t wrong = model.wrong_steps().size();
  const std::string text = wrong == 0 ? "no alarm" : counted(wrong, "alarm");
  list.AddText({axis.right() + 6, top - 1},
               widgets::ink(wrong == 0 ? palette::kFaintInk : palette::kCandidate), text.c_str());
}

std::string words_of_marks(const DebuggerModel& model, const TimeAxis& axis, float x) {
  std::string words;
  for (const auto& [mark, note] : model.bookmarks)
    if (std::abs(axis.x_of(time_of(mark, model.run().rows())) - x) <= kMark)
      words += "\nbookmark " + to_string(mark, model.run().names()) + (note.empty() ? "" : ": " + note);
  return words;
}

/// The lives of the selected node, thin as a leaf and thick with children, and the operators at it; or the
/// times when the selected objects were a pair.
void draw_ribbons(PanelContext& context, const TimeAxis& axis, float top) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const bool nothing = is_nothing(context.model.selection());
  const std::string name =
      nothing ? "selected" : to_string(context.model.selection(), context.model.run().names());
  draw_row_ground(axis, top, kTimelineRow, widgets::elided(name, kTimelineNames - 8),
                  nothing ? palette::kFaintInk : palette::kInk);
  for (const Ribbon& ribbon : context.model.shown_ribbons(axis.scale)) {
    const RibbonLook look = look_of(ribbon.kind);
    const float left = std::max(axis.left, axis.x_of(ribbon.begin()));
    const float right = std::min(axis.right(), std::max(left + 2, axis.x_of(ribbon.last_step)));
    const float margin = 1 + std::round(look.margin * (kTimelineRow - 3));
    list.AddRectFilled({left, top + margin}, {right, top + kTimelineRow - 1 - margin},
                       widgets::to_imgui(look.color, look.alpha));
  }
}

}  // namespace kerf
