#pragma once

#include <filesystem>

namespace kerf {

/// Where temporary files go: TMPDIR, or /tmp. Throws std::runtime_error if it is no folder.
std::filesystem::path temporary_folder();

}  // namespace kerf
