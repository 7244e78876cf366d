#pragma once

#include <filesystem>

namespace kerf {

/// Throws UsageError if `file` exists and may not be replaced: without `overwrite` nothing is, and a folder
/// or a device never. An empty path is no file.
void check_free(const std::filesystem::path& file, bool overwrite);

/// Throws UsageError if what is to be written is the recording that is read, by whatever name.
void check_not_input(const std::filesystem::path& out, const std::filesystem::path& recording);

}  // namespace kerf
