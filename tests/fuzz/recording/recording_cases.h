#pragma once

#include <filesystem>
#include <string>

#include "tests/fuzz/corpus.h"

namespace kerf::test {

// Each tries one input and returns what is wrong, empty if nothing is.

/// The bytes as a keyframe: refused, or a state from which a tree goes on soundly.
std::string keyframe_case(CaseBytes bytes);
/// The bytes as a block: refused, or steps that can be run.
std::string block_case(CaseBytes bytes);
/// The bytes as a shape of any kind, and as the looks of a keyframe: refused, or the same when written again.
std::string looks_case(CaseBytes bytes);
/// The bytes as changes of the values in a recording's tables: refused or named by `verify`, and, after the
/// hashes were made right again, read without harm.
std::string recording_case(CaseBytes bytes);

/// Twelve steps of a few objects, with something in every table: a keyframe after the sixth step, another
/// configuration from the ninth on, a decision, names, boxes, filters and pairs of another engine.
void record_small(const std::filesystem::path& path);
inline constexpr std::uint32_t kSmallKeyframe = 6;

}  // namespace kerf::test
