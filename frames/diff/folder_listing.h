#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace kerf {

using FilesByName = std::map<std::string, std::filesystem::path>;

/// All that lies in a folder and below it, by the way to it from there. Nothing is left out: what is in none
/// of these is a fault.
struct FolderListing {
  FilesByName frames;               ///< PNG files, whatever the case of their ending
  FilesByName others;               ///< any other file, and empty folders
  FilesByName beside;               ///< ids and draw lists of frames (frames/sequence/sidecar.h)
  FilesByName manifests;            ///< of sequences
  std::vector<std::string> faults;  ///< what cannot be looked at, such as links that lead nowhere
};

/// The ids and the draw list of a frame belong to it if both are there. Throws std::runtime_error if a folder
/// cannot be read.
FolderListing list_folder(const std::filesystem::path& folder);

/// What lies beside a frame in one of two folders does so in the other one, too, though it be only one of two
/// files there.
void agree_on_beside(FolderListing& a, FolderListing& b);

/// What is wrong with files that are no frames: each must be in both folders with the same bytes.
std::vector<std::string> compare_others(const FilesByName& reference, const FilesByName& test);

}  // namespace kerf
