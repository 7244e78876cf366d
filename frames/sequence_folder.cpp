#include "frames/sequence_folder.h"

#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

#include "frames/atomic_file.h"
#include "frames/errors.h"
#include "frames/manifest.h"
#include "frames/scene_catalog.h"

namespace kerf {
namespace {

/// Whether `file` is named as `frame_file_name` names the frames of one of our scenes.
bool is_frame(const std::string& file) {
  return std::ranges::any_of(scene_catalog(), [&](const CatalogScene& scene) {
    const std::string pattern = frame_file_name(scene.name, 0);
    return std::ranges::equal(file, pattern, [](unsigned char given, unsigned char wanted) {
      return std::isdigit(wanted) ? std::isdigit(given) != 0 : given == wanted;
    });
  });
}

/// Manifest first: while frames are going away nothing claims that they are there.
std::vector<std::filesystem::path> files_of_sequence(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  if (std::filesystem::exists(folder / kManifestName)) files.push_back(folder / kManifestName);
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (is_frame(entry.path().filename().string())) files.push_back(entry.path());
  }
  return files;
}

}  // namespace

SequenceFolder::SequenceFolder(std::filesystem::path path, bool overwrite) : path_(std::move(path)) {
  if (!std::filesystem::exists(path_)) return;
  if (!std::filesystem::is_directory(path_)) {
    throw UsageError(path_.string() + " is not a folder; choose another with --out");
  }
  if (!overwrite && !files_of_sequence(path_).empty()) {
    throw UsageError(path_.string() +
                     " holds a frame sequence already; choose another folder with --out, or " +
                     "replace the sequence with --overwrite");
  }
}

void SequenceFolder::make() const { make_writable_folder(path_); }

void SequenceFolder::clear() const {
  for (const std::filesystem::path& file : files_of_sequence(path_)) std::filesystem::remove(file);
}

}  // namespace kerf
