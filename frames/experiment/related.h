#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "frames/experiment/experiment_plan.h"
#include "frames/experiment/verdict.h"

namespace kerf {

/// The broad phases of the paper's section 2, behind the paper's tree, which the world follows.
std::span<const std::string_view> related_contestants();

/// What one of them did in a part of a run: means of its steps.
struct RelatedFigures {
  double candidates = 0;  ///< pairs whose boxes were compared
  double update = 0;      ///< milliseconds of processor: taking over boxes, bringing the structure up to date
  double collision = 0;   ///< milliseconds: finding the pairs
};

/// A run is cut into so many parts of equal length.
inline constexpr std::size_t kRelatedParts = 10;

/// By contestant.
struct RelatedRun {
  std::vector<std::array<RelatedFigures, kRelatedParts>> parts;
  std::vector<std::uint64_t> wrong;  ///< pairs that it missed, invented or reported twice, of all steps
};
RelatedRun summarise(const ExperimentRun& run);

/// Runs of each simulation, one for each seed and repeat.
using RelatedRuns = std::array<std::vector<RelatedRun>, 4>;

/// What a sentence says of a figure: that it is so many times another, or more, or less.
enum class RelatedMeasure : std::uint8_t {
  none,         ///< the sentence names no figure
  degradation,  ///< candidates over those of another, in the last part of the run
  update,       ///< time of updates over another's
  total,        ///< time of updates and collisions over another's
};

/// A sentence of section 2.
struct RelatedClaim {
  std::string_view words;  ///< the paper's, shortened
  RelatedMeasure measure = RelatedMeasure::none;
  std::string_view subject;
  std::string_view rival;
  bool more = true;            ///< the subject's figure is the larger one
  double factor = 1;           ///< at least so many times; 1: at all
  std::string_view note = {};  ///< how it is read, or why it cannot be judged
};
std::span<const RelatedClaim> related_claims();

struct RelatedVerdict {
  Outcome outcome = Outcome::cannot_be_judged;
  std::string figures;  ///< by simulation, the medians of its runs: "2.1, 1.4, 3, 1.2 times"
};
/// It holds if it does in every run of every simulation, partly if in some; simulations with fewer than
/// `kLeastSamples` runs do not count.
RelatedVerdict judge(const RelatedClaim& claim, const RelatedRuns& runs);

/// The page: what each of them is, how it was read, verdicts, figures over time.
std::string related_page(const ExperimentPlan& plan, const RelatedRuns& runs);

}  // namespace kerf
