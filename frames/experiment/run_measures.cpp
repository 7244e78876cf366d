#include "frames/experiment/run_measures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/median.h"
#include "frames/catalog/algorithm.h"
#include "frames/experiment/claim.h"

namespace kerf {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kStretch = 20;

/// What the measures ask of one contestant in one run.
class RunOf {
 public:
  RunOf(const ExperimentRun& run, std::string_view contestant)
      : run_(run),
        index_(
            static_cast<std::size_t>(std::ranges::find(contestants(), contestant) - contestants().begin())) {}

  /// Steps from `begin` to `end`, parts of the whole; at least one.
  [[nodiscard]] std::span<const ExperimentStep> part(double begin, double end) const {
    const auto size = static_cast<double>(run_.size());
    const std::size_t first = std::min(static_cast<std::size_t>(begin * size), run_.size() - 1);
    const std::size_t last = std::clamp(static_cast<std::size_t>(end * size), first + 1, run_.size());
    return std::span(run_).subspan(first, last - first);
  }
  [[nodiscard]] double mean(Measure measure, double begin = 0, double end = 1) const {
    const double mean = mean_of_medians(part(begin, end), value_of(measure));
    return measure == Measure::frames ? 1000 / mean : mean;
  }
  /// The greatest over the least fifth of the last two thirds.
  [[nodiscard]] double swing(const StepValue& value) const {
    double least = std::numeric_limits<double>::infinity();
    double most = 0;
    for (int k = 0; k < 5; ++k) {
      const double begin = (5.0 + 2 * k) / 15;
      const double mean = mean_of_medians(part(begin, begin + 2.0 / 15), value);
      if (std::isnan(mean)) return kNone;
      least = std::min(least, mean);
      most = std::max(most, mean);
    }
    return most / least;
  }
  /// For each moving object.
  [[nodiscard]] double mean_each(Measure measure, double begin, double end) const {
    return mean_of_medians(part(begin, end), value_each(measure));
  }
  [[nodiscard]] double growth_each(Measure measure) const {
    return mean_each(measure, 0.8, 1) / mean_each(measure, 0.2, 0.4);
  }
  [[nodiscard]] StepValue value_each(Measure measure) const {
    return [value = value_of(measure)](const ExperimentStep& row) { return value(row) / row.moving; };
  }
  /// Of frames a second: the milliseconds of one, since a rate is high where hardly anything is there.
  [[nodiscard]] StepValue value_of(Measure measure) const {
    switch (measure) {
      case Measure::frames:
        return [k = index_](const ExperimentStep& row) { return 1000 / row.fps(k); };
      case Measure::pairs:
        return [k = index_](const ExperimentStep& row) { return row.contestants[k].candidates; };
      case Measure::collision:
        return [k = index_](const ExperimentStep& row) { return row.contestants[k].collision; };
      default:
        return [k = index_](const ExperimentStep& row) { return row.contestants[k].update; };
    }
  }
  [[nodiscard]] StepValue leaves() const {
    return [k = index_](const ExperimentStep& row) { return double{1} * row.contestants[k].leaves; };
  }
  /// How many times as many pairs the first stretch has as the one with the fewest of the first tenth.
  [[nodiscard]] double pairs_start() const {
    const std::span<const ExperimentStep> tenth = part(0, 0.1);
    double first = kNone;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t begin = 0; begin < tenth.size(); begin += kStretch) {
      const double pairs = mean_of_medians(tenth.subspan(begin, std::min(kStretch, tenth.size() - begin)),
                                           value_of(Measure::pairs));
      if (begin == 0) first = pairs;
      least = std::min(least, pairs);
    }
    return first / least;
  }
  /// The part of the run before the number of objects begins to grow by a fracture; NaN if it never does.
  [[nodiscard]] double fracture() const {
    const auto grown = std::ranges::find_if(
        run_, [&](const ExperimentStep& row) { return row.moving > run_.front().moving; });
    return grown == run_.end() || grown == run_.begin()
               ? kNone
               : static_cast<double>(grown - run_.begin()) / static_cast<double>(run_.size());
  }
  [[nodiscard]] double depth_change() const {
    constexpr std::size_t kWithin = 10;
    double most = 0;
    for (std::size_t k = run_.size() / 3 + kWithin; k < run_.size(); ++k)
      most = std::max(most, std::abs(depth(k) - depth(k - kWithin)));
    return most;
  }
  /// How many levels the depth rises and falls in a part of the run, and one: no change is a figure, too.
  [[nodiscard]] double depth_moves(double begin, double end) const {
    double sum = 1;
    const std::span<const ExperimentStep> steps = part(begin, end);
    for (std::size_t k = 1; k < steps.size(); ++k)
      sum += std::abs(double{1} * steps[k].contestants[index_].height -
                      double{1} * steps[k - 1].contestants[index_].height);
    return sum;
  }

 private:
  [[nodiscard]] double depth(std::size_t k) const { return run_[k].contestants[index_].height; }

  const ExperimentRun& run_;
  std::size_t index_;
};

/// The paper's five.
std::span<const std::string_view> rivals() { return contestants().first(5); }

double lead_of(const ExperimentRun& run, std::string_view contestant) {
  double fastest = 0;
  for (const std::string_view other : rivals())
    if (other != contestant && !(other == kPaperTree && contestant.starts_with(kPaperTree)))
      fastest = std::max(fastest, RunOf(run, other).mean(Measure::frames));
  return RunOf(run, contestant).mean(Measure::frames) / fastest;
}

constexpr double kTenth = 0.1;

double measure_fracture(const RunOf& run, Measure measure) {
  const double fracture = run.fracture();
  constexpr double kLatest = 0.8;
  if (std::isnan(fracture) || fracture > kLatest) return kNone;
  const double after = fracture + 0.05;  // blocks fly apart meanwhile
  switch (measure) {
    case Measure::frames_before:
      return run.mean(Measure::frames, 0, fracture);
    case Measure::pairs_before:
      return run.mean(Measure::pairs, 0, fracture);
    case Measure::frames_gain:
      return run.mean(Measure::frames, after, 1) / run.mean(Measure::frames, 0, fracture);
    case Measure::object_pairs_gain:
      return run.mean_each(Measure::pairs, after, 1) / run.mean_each(Measure::pairs, 0, fracture);
    case Measure::depth_after_fracture:
      if (fracture < kTenth) return kNone;
      return run.depth_moves(fracture, fracture + kTenth) / run.depth_moves(fracture - kTenth, fracture);
    case Measure::depth_settling:
      return run.depth_moves(1 - kTenth, 1) / run.depth_moves(fracture, fracture + kTenth);
    default:
      return kNone;
  }
}

}  // namespace

double mean_of_medians(std::span<const ExperimentStep> steps, const StepValue& value) {
  double sum = 0;
  double count = 0;
  for (std::size_t begin = 0; begin < steps.size(); begin += kStretch) {
    std::vector<double> values;
    for (const ExperimentStep& row : steps.subspan(begin, std::min(kStretch, steps.size() - begin)))
      if (const double one = value(row); one >= 0) values.push_back(one);
    if (values.empty()) continue;
    sum += median(std::move(values));
    ++count;
  }
  return count > 0 ? sum / count : kNone;
}

double measure(const ExperimentRun& run, std::string_view contestant, Measure measure) {
  const RunOf one(run, contestant);
  switch (measure) {
    case Measure::frames:
    case Measure::pairs:
    case Measure::collision:
    case Measure::overhead:
      return one.mean(measure);
    case Measure::lead:
      return lead_of(run, contestant);
    case Measure::object_pairs_growth:
      return one.growth_each(Measure::pairs);
    case Measure::object_collision_growth:
      return one.growth_each(Measure::collision);
    case Measure::pairs_start:
      return one.pairs_start();
    case Measure::object_pairs_swing:
      return one.swing(one.value_each(Measure::pairs));
    case Measure::frames_swing:
      return one.swing(one.value_of(Measure::frames));
    case Measure::leaves_swing:
      return one.swing(one.leaves());
    case Measure::depth_change:
      return one.depth_change();
    default:
      return measure_fracture(one, measure);
  }
}

std::vector<double> samples_of(const std::vector<TimedRun>& runs, std::string_view contestant,
                               Measure measure) {
  std::vector<double> samples;
  for (const TimedRun& run : runs)
    if (traits_of(measure).is_time || run.repeat == 1)
      samples.push_back(kerf::measure(run.steps, contestant, measure));
  return samples;
}

ClaimFigures claim_figures(const ExperimentRuns& runs, std::string_view tree) {
  ClaimFigures figures;
  const auto add = [&](const Quantity& quantity) {
    auto [place, is_new] = figures.try_emplace(quantity);
    const std::vector<TimedRun>& of_simulation = runs[static_cast<std::size_t>(quantity.simulation - 1)];
    const std::string_view contestant = quantity.contestant == kPaperTree ? tree : quantity.contestant;
    if (is_new) place->second = samples_of(of_simulation, contestant, quantity.measure);
  };
  for (const Claim& claim : claims())
    for (const Comparison& comparison : claim.comparisons) {
      add(comparison.subject);
      if (comparison.rival) add(*comparison.rival);
    }
  return figures;
}

}  // namespace kerf
