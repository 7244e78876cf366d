#pragma once

#include <functional>

#include "frames/bench/random/random_report.h"

namespace kerf {

/// Draws the request's scenes one after another and measures each; `add` gets each that came to its end.
void measure_random(const BenchRequest& request, const CellWatch& watch,
                    const std::function<void(RandomOutcome)>& add);

}  // namespace kerf
