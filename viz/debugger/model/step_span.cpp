#include "viz/debugger/model/step_span.h"

#include <cmath>

#include "core/base/counted.h"
#include "core/query/text.h"

namespace kerf {
namespace {

std::string range_text(const LaneRange& range, const std::string& unit = "") {
  if (range.is_absent()) return "-";
  const std::string least = number_text(double{range.least}, 4);
  const std::string greatest = number_text(double{range.greatest}, 4);
  return (least == greatest ? least : least + " to " + greatest) + unit;
}

std::string operators_text(const SpanFigures& figures) {
  std::string text;
  for (std::size_t k = 0; k < figures.operators.size(); ++k)
    if (figures.operators[k] > 0)
      text += (text.empty() ? "" : ", ") + std::to_string(figures.operators[k]) + " " +
              std::string(to_string(static_cast<Operator>(k)));
  return text.empty() ? "no operator" : text;
}

}  // namespace

StepSpan steps_between(double a, double b, std::uint32_t steps) {
  const auto [low, high] = std::minmax(a, b);
  const auto last_step = static_cast<double>(steps);
  constexpr double kSlack = 0.1;  // of a step: a hand does not hit its border
  const auto first = static_cast<std::uint32_t>(std::clamp(std::floor(low + kSlack) + 1, 1.0, last_step));
  return {first,
          std::max(first, static_cast<std::uint32_t>(std::clamp(std::ceil(high - kSlack), 1.0, last_step)))};
}

SpanFigures figures_of(const StepSpan& steps, std::span<const StepRow> rows, const std::vector<Lane>& lanes) {
  SpanFigures figures;
  figures.steps = steps;
  for (std::size_t k = 0; k < figures.operators.size(); ++k) {
    const auto until = [&](std::uint32_t step) {
      return step == 0 ? 0 : rows[step - 1].statistics.operators[k];
    };
    figures.operators[k] = until(steps.last) - until(steps.first - 1);
  }
  const auto range = [&](LaneOf lane) { return lanes[index_of(lane)].range(steps.first, steps.last); };
  figures.pairs = range(LaneOf::pairs);
  figures.height = range(LaneOf::height);
  figures.redundancy = range(LaneOf::redundancy);
  figures.seconds = 1e-3 * lanes[index_of(LaneOf::milliseconds)].sum(steps.first, steps.last);
  return figures;
}

std::string to_text(const SpanFigures& figures, const GivenNames& names) {
  const StepSpan& steps = figures.steps;
  return counted(steps.count(), "step") + ": " + operators_text(figures) + "; pairs " +
         range_text(figures.pairs) + "; height " + range_text(figures.height) + "; redundancy " +
         range_text(figures.redundancy, " %") + "; " + number_text(1e3 * figures.seconds, 4) + " ms; " +
         names.steps(steps.first, steps.last);
}

}  // namespace kerf
