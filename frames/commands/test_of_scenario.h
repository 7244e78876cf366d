#pragma once

#include <filesystem>
#include <string>

#include "core/query/scenario.h"

namespace kerf {

/// A C++ test that makes the scenario's requests again, compares the pairs of each step with brute force and
/// the last state with `hash`. It needs Kerf's core and GoogleTest and nothing else. `condition` is named in
/// it.
template <int D>
std::string test_of_scenario(const Scenario<D>& scenario, const std::string& condition, std::uint64_t hash);

/// Whether the file begins as such a test does.
bool is_test_of_scenario(const std::filesystem::path& file);

}  // namespace kerf
