#include "frames/import/alike_steps.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "frames/import/written_digits.h"
#include "frames/support/errors.h"

namespace kerf {
namespace {

/// The most that a step of a table has: printf's %g leaves out zeros at the end.
struct StepWriting {
  std::int64_t digits = 0;  ///< of numbers only: a date is no rounded number
  std::int64_t decimals = 0;

  void note(const GivenStep& step) {
    const std::string_view text = step.text;
    const bool is_date = step.is_date();
    const auto written = read_digits(is_date ? text.substr(std::min(text.find('.'), text.size())) : text);
    if (!written) return;
    decimals = std::max(decimals, written->decimals);
    if (!is_date) digits = std::max(digits, written->significant);
  }

  /// Below this, two times of about this size are one where they are written so, rounded or cut.
  [[nodiscard]] long double last_place(long double time) const {
    constexpr std::int64_t kLeastDigits = 6;   // printf's; fewer are what the numbers have
    constexpr long double kBelowOne = 0.999L;  // since a difference of one place is rounded itself
    long double place = std::pow(10.0L, static_cast<long double>(-decimals));
    if (digits >= kLeastDigits && time != 0)
      place = std::max(place, std::pow(10.0L, std::floor(std::log10(std::abs(time))) + 1 -
                                                  static_cast<long double>(digits)));
    return kBelowOne * place;
  }
};

StepWriting writing_of_both(const std::vector<BoxStep>& boxes, const std::vector<GivenPairs>& pairs) {
  StepWriting of_boxes;
  StepWriting of_pairs;
  for (const BoxStep& box : boxes) of_boxes.note(box.step);
  for (const GivenPairs& of_step : pairs) of_pairs.note(of_step.step);
  return {std::min(of_boxes.digits, of_pairs.digits), std::min(of_boxes.decimals, of_pairs.decimals)};
}

/// Between the steps of boxes before and after this place, or before the last one; 0: there is one step.
long double length_at(const std::vector<BoxStep>& boxes, std::size_t after) {
  const std::size_t later = std::min(after, boxes.size() - 1);
  return later == 0 ? 0 : boxes[later].step.time - boxes[later - 1].step.time;
}

bool have_step(const std::vector<GivenPairs>& pairs, long double time) {
  const auto found = std::ranges::lower_bound(pairs, time, {}, [](const auto& of) { return of.step.time; });
  return found != pairs.end() && found->step.time == time;
}

}  // namespace

void check_alike(const std::vector<BoxStep>& boxes, const std::vector<GivenPairs>& pairs,
                 const std::string& pairs_name) {
  const StepWriting writing = writing_of_both(boxes, pairs);
  for (const auto& [step, lines] : pairs) {
    const auto found =
        std::ranges::lower_bound(boxes, step.time, {}, [](const BoxStep& box) { return box.step.time; });
    if (found != boxes.end() && found->step.time == step.time) continue;
    const auto after = static_cast<std::size_t>(found - boxes.begin());
    const long double nearest = std::min(writing.last_place(step.time), length_at(boxes, after) / 2);
    for (std::size_t k = std::max<std::size_t>(after, 1) - 1; k <= after && k < boxes.size(); ++k) {
      const GivenStep& other = boxes[k].step;
      if (std::abs(other.time - step.time) >= nearest || have_step(pairs, other.time)) continue;
      throw UsageError(pairs_name + ", line " + std::to_string(lines.front().line) + ": step " + step.text +
                       " is no step of the boxes, but step " + other.text +
                       " is the same in as many digits: write steps alike in all tables");
    }
  }
}

}  // namespace kerf
