#pragma once

#include "viz/debugger/gui/widgets.h"
#include "viz/debugger/panels/panel.h"

namespace kerf {

inline constexpr float kTimelineNames = 188;  ///< width of the column of names
inline constexpr float kTimelineValue = 54;   ///< of each of the columns of values at the right
inline constexpr float kTimelineRow = 15;     ///< height of a row of text

/// The columns of pixels above which the rows of the timeline are drawn.
struct TimeAxis {
  float left = 0;
  TimeScale scale;
  double fineness = 1;  ///< pixels of a unit, each with a column of its own

  [[nodiscard]] float width() const { return static_cast<float>(scale.width); }
  [[nodiscard]] float right() const { return left + width(); }
  [[nodiscard]] std::size_t columns() const { return static_cast<std::size_t>(scale.width * fineness); }
  /// The left end of a column.
  [[nodiscard]] float x_of_column(std::size_t k) const {
    return left + static_cast<float>(scale.width * static_cast<double>(k) / static_cast<double>(columns()));
  }
  [[nodiscard]] float x_of(double time) const { return left + static_cast<float>(scale.x_of(time)); }
  [[nodiscard]] double time_at(float x) const { return scale.time_at(double{x - left}); }
  [[nodiscard]] bool has(double time) const {
    return scale.window.first() <= time && time <= scale.window.last();
  }
};

/// Calls `draw(left, right, value)` for neighbouring columns of the same value, not for the value 0:
/// there are thousands of columns.
template <class ValueOf, class Draw>
void for_each_stretch(const TimeAxis& axis, ValueOf value_of, Draw draw) {
  const std::size_t columns = axis.columns();
  int last = 0;
  std::size_t begin = 0;
  for (std::size_t k = 0; k <= columns; ++k) {
    const int value = k < columns ? value_of(axis.scale.window.column(k, columns)) : 0;
    if (value == last) continue;
    if (last != 0) draw(axis.x_of_column(begin), axis.x_of_column(k), last);
    last = value;
    begin = k;
  }
}

/// Paper for a row, and its name.
void draw_row_ground(const TimeAxis& axis, float top, float height, const std::string& name, Color ink);

// The rows of the timeline, each below a y and `kTimelineRow` high, except the lanes.
void draw_time_ruler(PanelContext& context, const TimeAxis& axis, float top, float bottom);
/// In at most that height; returns what they took.
float draw_lanes(PanelContext& context, const TimeAxis& axis, float top, float height);
void draw_event_row_of_time(PanelContext& context, const TimeAxis& axis, float top);
void draw_marks(PanelContext& context, const TimeAxis& axis, float top);
/// The bookmarks at a place, a line each with its note; a line begins with an end of line.
std::string words_of_marks(const DebuggerModel& model, const TimeAxis& axis, float x);
void draw_ribbons(PanelContext& context, const TimeAxis& axis, float top);
void draw_minimap(PanelContext& context, const TimeAxis& axis, float top);
void draw_timeline_tools(PanelContext& context);

}  // namespace kerf
