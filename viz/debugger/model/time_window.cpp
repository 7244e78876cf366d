#include "viz/debugger/model/time_window.h"

#include <algorithm>
#include <cmath>

namespace kerf {
namespace {

constexpr double kPixelsPerEvent = 4;  ///< from here on a click can hit one event
constexpr double kLeastEvents = 6;     ///< so many are seen at the highest magnification

/// The row of the step that lasts at that time; null if the run is empty.
const StepRow* row_at(double time, std::span<const StepRow> rows) {
  if (rows.empty()) return nullptr;
  const auto last = static_cast<double>(rows.size() - 1);
  return &rows[static_cast<std::size_t>(std::clamp(std::floor(time), 0.0, last))];
}

/// The parts of a step's time: its events, and its end.
double parts_of(std::uint64_t events) { return static_cast<double>(events) + 1; }

/// 1, 2 or 5 times a power of ten, not below `least`.
std::int64_t round_spacing(double least) {
  std::int64_t power = 1;
  while (static_cast<double>(power) * 10 < least) power *= 10;
  for (const std::int64_t factor : {1, 2, 5})
    if (static_cast<double>(factor * power) >= least) return factor * power;
  return 10 * power;
}

/// What to add to a step's number for its name; 0 unless names count up by one.
std::int64_t name_shift(const GivenNames& names) {
  constexpr double kMost = 9e15;  // a double holds every whole number up to here
  if (!names.names_steps()) return 0;
  const auto count = static_cast<std::uint32_t>(names.steps().size());
  const auto first = static_cast<double>(names.step_number(1));
  const auto last = static_cast<double>(names.step_number(count));
  if (std::abs(first) > kMost || first != std::round(first) || last - first != count - 1.0) return 0;
  return static_cast<std::int64_t>(first) - 1;
}

}  // namespace

TimeWindow::TimeWindow(std::uint32_t steps) : whole_(std::max(1U, steps)), span_(whole_) {}

void TimeWindow::place(double first, double span) {
  span_ = std::min(span, whole_);
  first_ = std::clamp(first, 0.0, whole_ - span_);
}

void TimeWindow::zoom(double factor, double at, double least_span) {
  const double span = std::clamp(span_ / factor, std::min(least_span, whole_), whole_);
  place(at - (at - first_) * span / span_, span);
}

void TimeWindow::show(double first, double last) {
  if (last > first) place(first, last - first);
}

void TimeWindow::reveal(double time) {
  if (time < first()) place(time - 0.1 * span_, span_);
  if (time > last()) place(time - 0.9 * span_, span_);
}

TimeWindow::Column TimeWindow::column(std::size_t number, std::size_t columns) const {
  const auto step_at = [&](std::size_t edge) {
    constexpr double kRounding = 1e-6;  // of a step
    const double share = static_cast<double>(edge) / static_cast<double>(columns);
    return static_cast<std::uint32_t>(first_ + share * span_ + kRounding);
  };
  const std::uint32_t before = std::min(step_at(number), static_cast<std::uint32_t>(whole_) - 1);
  return {before, std::max(before + 1, step_at(number + 1))};
}

double time_of(const Position& position, std::span<const StepRow> rows) {
  if (position.is_end() || position.step == 0 || position.step > rows.size()) return position.step;
  const StepRow& row = rows[position.step - 1];
  const double part = static_cast<double>(position.event - row.first_event) + 1;
  return position.step - 1 + part / parts_of(row.events);
}

Position moment_at(double time, double pixels_per_step, std::span<const StepRow> rows) {
  const StepRow* const row = row_at(time, rows);
  if (row == nullptr) return {};
  const auto steps = static_cast<double>(rows.size());
  if (!events_are_apart(pixels_per_step, row->events))
    return Position::end_of(static_cast<std::uint32_t>(std::lround(std::clamp(time, 0.0, steps))));
  const double part = std::round((time - (row->step - 1.0)) * parts_of(row->events));
  if (part < 1) return Position::end_of(row->step - 1);
  if (part >= parts_of(row->events)) return Position::end_of(row->step);
  return {row->step, row->first_event + static_cast<std::uint64_t>(part) - 1};
}

bool events_are_apart(double pixels_per_step, std::uint64_t events) {
  return pixels_per_step >= kPixelsPerEvent * parts_of(events);
}

double least_span(double time, std::span<const StepRow> rows) {
  const StepRow* const row = row_at(time, rows);
  return row == nullptr ? 1 : std::min(1.0, kLeastEvents / parts_of(row->events));
}

std::vector<std::uint32_t> axis_steps(const TimeWindow& window, std::size_t most, const GivenNames& names) {
  std::vector<std::uint32_t> steps;
  const std::int64_t shift = name_shift(names);
  const std::int64_t spacing =
      round_spacing(window.span() / static_cast<double>(std::max<std::size_t>(1, most)));
  const auto first = static_cast<std::int64_t>(std::ceil(window.first())) + shift;
  const auto last = static_cast<std::int64_t>(std::floor(window.last())) + shift;
  // Rounded up for names below zero, too.
  std::int64_t next = first / spacing * spacing;
  if (next < first) next += spacing;
  if (next > last) next = last;
  for (; first <= next && next <= last; next += spacing)
    if (next != shift || !names.names_steps()) steps.push_back(static_cast<std::uint32_t>(next - shift));
  return steps;
}

}  // namespace kerf
