#pragma once

#include <cstdint>
#include <map>
#include <string_view>
#include <vector>

namespace kerf {

/// What the paper's statements compare, one figure a run. "Pairs" are those that a structure leaves to be
/// tested: all report the same.
enum class Measure : std::uint8_t {
  frames,                   ///< frames a second with that broad phase alone in the loop
  pairs,                    ///< a step
  collision,                ///< milliseconds a step to find the pairs
  overhead,                 ///< milliseconds a step to take over boxes and bring the structure up to date
  lead,                     ///< frames a second over those of the fastest other of the paper's five
  frames_before,            ///< frames a second before the first fracture
  pairs_before,             ///< pairs a step before the first fracture
  frames_gain,              ///< frames a second after the first fracture over those before
  object_pairs_gain,        ///< pairs for each moving object after the first fracture over those before
  object_pairs_growth,      ///< pairs for each moving object in the last fifth of the run over those in the
                            ///< second
  object_collision_growth,  ///< collision time for each moving object: likewise
  pairs_start,              ///< pairs in the first twenty steps over the least of as many in the first tenth
  object_pairs_swing,    ///< pairs for each moving object: the greatest over the least fifth of the last two
                         ///< thirds
  frames_swing,          ///< frames a second: likewise
  leaves_swing,          ///< leaves of the tree: likewise
  depth_change,          ///< greatest change of a tree's depth within ten steps, after the first third
  depth_after_fracture,  ///< changes of depth in the tenth of the run after the first fracture over the tenth
                         ///< before, if there is one
  depth_settling,        ///< changes of depth in the last tenth of the run over the tenth after the first
                         ///< fracture
};

/// Which of two figures is the better one.
enum class Merit : std::uint8_t { less, more, none };

struct MeasureTraits {
  std::string_view name;  ///< "collision time"
  std::string_view unit;  ///< " ms"
  Merit merit = Merit::less;
  bool is_time = true;  ///< differs from repeat to repeat; counts differ by seed only
};
const MeasureTraits& traits_of(Measure measure);

/// One figure of the experiment.
struct Quantity {
  int simulation = 1;
  std::string_view contestant;
  Measure measure = Measure::frames;

  friend auto operator<=>(const Quantity&, const Quantity&) = default;
};

/// The samples of each quantity, one a run: the same place in two lists is the same run, where both are of
/// the same kind. NaN: the run has no such figure.
using ClaimFigures = std::map<Quantity, std::vector<double>>;

}  // namespace kerf
