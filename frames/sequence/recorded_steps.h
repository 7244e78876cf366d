#pragma once

#include <cstdint>
#include <string>

#include "core/base/given_names.h"
#include "frames/support/step_range.h"

namespace kerf {

/// The steps A to B of a recording of so many steps, a frame every N: "B", "A:B" or "A:B:N". A and B are what
/// the engine of an import calls its steps; where it calls them by dates, which have colons themselves, ".."
/// stands for each colon, and numbers are counted from 1. Throws UsageError that says which steps there are.
StepRange parse_recorded_steps(const std::string& text, const GivenNames& names, std::uint32_t steps);

}  // namespace kerf
