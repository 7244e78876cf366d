#pragma once

#include <array>
#include <string>
#include <string_view>

#include "viz/debugger/model/run.h"

namespace kerf {

/// The scheduler as the paper prints it (section 5.2, Algorithm 1).
inline constexpr std::array<std::string_view, 18> kAlgorithm1{
    "if no deferred events are pending then",
    "  start traversal at the root n",
    "  if n is unbalanced then",
    "    evaluate the balance operator",
    "    if balancing is valid: balance",
    "    else schedule swap",
    "    stop traversal",
    "  end if",
    "  check for shift-split, split, merge; schedule",
    "  if any event was scheduled stop traversal",
    "  else repeat 3-10 for each subtree of n",
    "end if",
    "how many events to perform, by the list's size",
    "process shift-split events",
    "process split events",
    "process swap events",
    "process merge events",
    "defer the remaining events",
};

/// The position in a step's run of Algorithm 1, and the decisions of each line so far.
struct Algorithm1Trace {
  int line = 0;                         ///< 1 to 18; 0: Algorithm 1 is not at work
  std::array<std::string, 18> decided;  ///< empty: nothing
};
Algorithm1Trace trace_algorithm_1(const Run& run);

}  // namespace kerf
