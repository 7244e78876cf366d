#pragma once

#include "viz/debugger/model/run_of.h"

namespace kerf {

/// What a view of a run must know of all of it: it may not depend on the way to a moment, nor change from
/// one to the next.
template <int D>
struct RunSurvey {
  Box<D> box;                 ///< that is framed
  double population_end = 1;  ///< of the colours of leaves, at most as in pictures; a leaf may have more
  double cost_end = 1;
};

/// Looks at a few moments spread over the run, and returns to the present one.
template <int D>
RunSurvey<D> survey(RunOf<D>& run);

}  // namespace kerf
