#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/recording/recording_info.h"
#include "core/replay/position.h"

namespace kerf {

// The time of a run counts in steps: step k lasts from k - 1 to k, and its events are spread evenly over
// that.

/// The part of a run's time that the lanes show.
class TimeWindow {
 public:
  TimeWindow() = default;
  explicit TimeWindow(std::uint32_t steps);

  [[nodiscard]] double first() const { return first_; }
  [[nodiscard]] double last() const { return first_ + span_; }
  [[nodiscard]] double span() const { return span_; }
  /// Of the whole run: 1 at least, so that an empty run has an axis, too.
  [[nodiscard]] double whole() const { return whole_; }
  [[nodiscard]] bool shows_all() const { return span_ >= whole_; }

  /// Magnifies by a factor, below 1: shows more. The time `at` stays where it is, as far as the run's ends
  /// allow.
  void zoom(double factor, double at, double least_span);
  void pan(double time) { place(first_ + time, span_); }
  void show(double first, double last);
  void show_all() { place(0, whole_); }
  /// Pans, if it has to, until the time is seen.
  void reveal(double time);

  /// A stretch of steps where they share a column of pixels; one step where a step has several columns.
  struct Column {
    std::uint32_t before = 0;  ///< the step before the first
    std::uint32_t last = 0;
  };
  [[nodiscard]] Column column(std::size_t number, std::size_t columns) const;

  friend bool operator==(const TimeWindow&, const TimeWindow&) = default;

 private:
  void place(double first, double span);

  double whole_ = 1;
  double first_ = 0;
  double span_ = 1;
};

/// The window over so many pixels.
struct TimeScale {
  TimeWindow window;
  double width = 1;

  [[nodiscard]] double pixels_per_step() const { return width / window.span(); }
  [[nodiscard]] double x_of(double time) const { return (time - window.first()) * pixels_per_step(); }
  [[nodiscard]] double time_at(double x) const { return window.first() + x / pixels_per_step(); }
  friend bool operator==(const TimeScale&, const TimeScale&) = default;
};

inline constexpr double kZoomOfWheel = 1.25;  ///< a turn of the wheel magnifies by so much
inline constexpr double kZoomOfKey = 2;
inline constexpr double kPanOfWheel = 0.1;  ///< of what is seen

double time_of(const Position& position, std::span<const StepRow> rows);
/// The moment that a click at a time means: the end of a step, or an event where there are enough pixels
/// between them.
Position moment_at(double time, double pixels_per_step, std::span<const StepRow> rows);
/// Whether a step's events are far enough apart to be seen and pressed.
bool events_are_apart(double pixels_per_step, std::uint64_t events);
/// The least span of a window: it shows a few events of the step at that time.
double least_span(double time, std::span<const StepRow> rows);

/// The steps that an axis labels, `most` at most, one at least if any ends in the window: round numbers in
/// the step's names where these are whole numbers that count up by one, else in the steps' own numbers.
std::vector<std::uint32_t> axis_steps(const TimeWindow& window, std::size_t most, const GivenNames& names);

}  // namespace kerf
