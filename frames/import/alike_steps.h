#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "frames/import/given_pairs.h"

namespace kerf {

/// A step of a table of boxes.
struct BoxStep {
  GivenStep step;
  std::size_t line = 0;  ///< its first
};

/// Throws UsageError if pairs are of a step that no boxes have, but a step of boxes next to it, which has no
/// pairs, is the same one in as many digits as both tables have: times that were not written alike would make
/// a right engine's pairs missed in one step and extra in the other. Both rise; the message begins with
/// `pairs_name` and the line.
void check_alike(const std::vector<BoxStep>& boxes, const std::vector<GivenPairs>& pairs,
                 const std::string& pairs_name);

}  // namespace kerf
