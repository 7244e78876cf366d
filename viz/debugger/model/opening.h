#pragma once

#include <cstdint>
#include <span>

#include "core/recording/recording_info.h"

namespace kerf {

/// The first step at which the tree has four fifths of the leaves that it ever has; 0 of a run without steps.
std::uint32_t opening_step(std::span<const StepRow> rows);

}  // namespace kerf
