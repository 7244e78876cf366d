#pragma once

#include <filesystem>

namespace kerf {

/// The file to open for a recording of that name. This is the file itself; where there is none, it is the
/// part in which the recording is being built, or which a run that was killed has left (PartFile). Throws
/// std::runtime_error, with their names, if there are several parts; where there is nothing at all, returns
/// `path`.
std::filesystem::path recording_at(const std::filesystem::path& path);

}  // namespace kerf
