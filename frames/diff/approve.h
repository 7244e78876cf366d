#pragma once

#include <string>
#include <vector>

#include "frames/diff/diff_result.h"

namespace kerf {

/// Puts each frame of the test side that is not the same in place of its reference, with its ids; frames that
/// are the same, and references without a frame, are left alone. Names those that were put. Throws
/// std::runtime_error before anything is written if one of them is no whole picture, std::runtime_error if
/// one cannot be written.
std::vector<std::string> approve_frames(const DiffResult& result);

}  // namespace kerf
