#pragma once

#include <functional>
#include <string>
#include <vector>

#include "frames/diff/diff_result.h"

namespace kerf {

/// Replaces the reference of each frame that differs by the new frame, with its ids; equal frames, and
/// references without a frame, are left alone. Returns the names of the replaced ones. Throws UnusableInput
/// before anything is written if one of them is no whole picture, std::runtime_error if one cannot be
/// written. `stop` is asked before each frame; where it says so, that and the following ones are left alone.
std::vector<std::string> approve_frames(const DiffResult& result, const std::function<bool()>& stop = {});

/// The same for the manifests that differ, unless there is none of the new frames, or a frame of its folder
/// is missing.
std::vector<std::string> approve_manifests(const DiffResult& result);

}  // namespace kerf
