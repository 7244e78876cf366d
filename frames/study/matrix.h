#pragma once

#include <filesystem>
#include <vector>

#include "frames/study/json_object.h"
#include "frames/study/study.h"

namespace kerf {

/// The cells of one matrix of a study: each combination of its lists, repeats outermost and broad phases
/// innermost, so that what is compared is measured in the same minutes. A recording's path begins at
/// `folder`. Throws UsageError as JsonObject does.
std::vector<StudyCell> read_matrix(JsonObject& matrix, const std::filesystem::path& folder);

/// Throws UsageError for more cells than a study can have.
void refuse_too_many(const JsonObject& matrix, double cells);

/// The parts of it: a matrix of motions or scenes, and one of frames.
std::vector<StudyCell> read_runs(JsonObject& matrix);
std::vector<StudyCell> read_frames(JsonObject& matrix, const std::filesystem::path& folder);

}  // namespace kerf
