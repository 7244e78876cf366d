#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace kerf::house {

/// The project's own files as git knows them, new ones that are not ignored included; paths from the root.
/// Throws std::runtime_error when git fails.
std::vector<std::filesystem::path> project_files();

/// Those of them that are C++.
std::vector<std::filesystem::path> source_files();

/// The lines of one of them. A file that is not text has none.
std::vector<std::string> lines_of(const std::filesystem::path& file);

}  // namespace kerf::house
