#pragma once

#include <string>

#include "frames/study/join.h"

namespace kerf {

/// A page that opens offline: for each scene plots of times and candidates with confidence intervals, and a
/// table of their figures; and which cells are missing. `command` makes it again. Throws std::runtime_error
/// if gnuplot fails.
std::string study_page(const Study& study, const JoinedStudy& joined, const std::string& command);

}  // namespace kerf
