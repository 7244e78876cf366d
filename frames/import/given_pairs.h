#pragma once

#include <filesystem>
#include <vector>

#include "frames/import/box_lines.h"
#include "frames/import/oddities.h"

namespace kerf {

/// A pair as another engine reported it.
struct GivenPair {
  GivenId a;
  GivenId b;
  std::size_t line = 0;
};

/// The pairs of one step, in the order in which they were reported.
struct GivenPairs {
  GivenStep step;
  std::vector<GivenPair> pairs;
};

/// Reads step,a,b, by the names of a heading in any order, or without one in this order; the result is in the
/// order of the steps. Throws as CsvTable does, and UsageError for a file of which not even a heading is
/// there.
std::vector<GivenPairs> read_given_pairs(const std::filesystem::path& path, Oddities& oddities);

/// Reads a,b: pairs that hold for all steps.
std::vector<GivenPair> read_ignored_pairs(const std::filesystem::path& path, Oddities& oddities);

}  // namespace kerf
