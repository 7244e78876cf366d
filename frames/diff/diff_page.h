#pragma once

#include <string>

#include "frames/diff/diff_result.h"

namespace kerf {

/// Frames that a page shows with their pictures; of the others only the names.
inline constexpr std::size_t kMostShownFrames = 100;

/// A self-contained page that shows each frame that differs: new and reference, the heat map of FLIP, the
/// difference of the ids, a magnifier over all of them, and the command that approves.
std::string diff_page(const DiffResult& result);

/// That command for a POSIX shell.
std::string approve_command(const DiffResult& result);

}  // namespace kerf
