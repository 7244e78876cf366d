#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "frames/diff/folder_listing.h"

namespace kerf {

/// How the manifests of two sequences differ. An empty path: that side has none.
struct ManifestDiff {
  std::string name;  ///< the way to it from the folders that are compared
  std::filesystem::path reference;
  std::filesystem::path test;
  std::vector<std::string> reasons;  ///< one line each
};

/// Those that differ. What was asked for and what each frame shows must be the same. Which part of the frames
/// was made here, whether all are made, and the hashes of their pixels do not count: the pictures say that.
std::vector<ManifestDiff> compare_manifests(const FilesByName& reference, const FilesByName& test);

}  // namespace kerf
