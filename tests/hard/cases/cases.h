#pragma once

#include "tests/hard/cases.h"

// The hard cases, each script written once for both dimensions.
namespace kerf::test {

std::span<const HardCase> values_cases();
std::span<const HardCase> extremes_cases();
std::span<const HardCase> structure_cases();
std::span<const HardCase> motion_cases();
std::span<const HardCase> operators_cases();

}  // namespace kerf::test
