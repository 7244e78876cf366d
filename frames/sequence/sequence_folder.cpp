#include "frames/sequence/sequence_folder.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "core/files/part_file.h"
#include "frames/catalog/scene_catalog.h"
#include "frames/sequence/manifest.h"
#include "frames/support/atomic_file.h"
#include "frames/support/errors.h"

namespace kerf {
namespace {

bool is_named_like(const std::string& file, const std::string& name) {
  const std::string pattern = frame_file_name(name, 0);
  return std::ranges::equal(file, pattern, [](unsigned char given, unsigned char wanted) {
    return wanted == '0' ? std::isdigit(given) != 0 : given == wanted;
  });
}

/// The frame to which a file beside it belongs.
std::string frame_of(const std::string& file) {
  for (const std::string ending : {".ids.png", ".draw.json"})
    if (file.ends_with(ending)) return file.substr(0, file.size() - ending.size()) + ".png";
  return file;
}

/// Whether `file` has a name that `frame_file_name` gives to frames of `name` or of one of our scenes.
bool is_frame(const std::string& file, const std::string& name) {
  return is_named_like(file, name) || std::ranges::any_of(scene_catalog(), [&](const CatalogScene& scene) {
           return is_named_like(file, scene.name);
         });
}

KeptFrames hashes_of(const Manifest& manifest) {
  KeptFrames hashes;
  for (const FrameRecord& frame : manifest.frames) hashes.emplace(frame.index, frame.pixel_hash);
  return hashes;
}

}  // namespace

SequenceFolder::SequenceFolder(std::filesystem::path path, std::string name)
    : path_(std::move(path)), name_(std::move(name)) {
  if (std::filesystem::exists(path_) && !std::filesystem::is_directory(path_))
    throw UsageError(path_.string() + " is not a folder; choose another");
}

/// Manifest first: it must never name frames that are gone.
std::vector<std::filesystem::path> SequenceFolder::files_of_sequence() const {
  std::vector<std::filesystem::path> files;
  if (!std::filesystem::exists(path_)) return files;
  if (std::filesystem::exists(path_ / kManifestName)) files.push_back(path_ / kManifestName);
  for (const auto& entry : std::filesystem::directory_iterator(path_))
    if (is_frame(frame_of(entry.path().filename().string()), name_)) files.push_back(entry.path());
  return files;
}

void SequenceFolder::check_free(bool overwrite) const {
  if (overwrite || files_of_sequence().empty()) return;
  throw UsageError(path_.string() +
                   " holds a frame sequence already; choose another folder with --out, replace the " +
                   "sequence with --overwrite, or make what it lacks with --resume");
}

void SequenceFolder::check_apart(const std::filesystem::path& out) const {
  if (out.empty()) return;
  const auto resolved = [](const std::filesystem::path& path) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(path));
  };
  const std::string file = out.filename().string();
  const bool is_own = file == kManifestName || is_frame(frame_of(file), name_);
  if (is_own && resolved(out).parent_path() == resolved(path_ / file).parent_path())
    throw UsageError(out.string() + " is the name of a file of the sequence in " + path_.string() +
                     "; choose another name");
}

KeptFrames SequenceFolder::frames_of(const Manifest& manifest) const {
  if (files_of_sequence().empty()) return {};
  if (!std::filesystem::exists(path_ / kManifestName))
    throw UsageError(path_.string() + " has frames but no " + kManifestName +
                     " to describe them; choose another folder, or replace them with --overwrite");
  const Manifest earlier = read_manifest(path_);
  std::string difference = first_difference(earlier.header, manifest.header);
  if (!(earlier.shard == manifest.shard)) difference = "another shard";
  if (!difference.empty())
    throw UsageError("--resume: " + path_.string() + " holds another sequence (" + difference +
                     "); give the options with which it was begun, or choose another folder with --out");
  return hashes_of(earlier);
}

KeptFrames SequenceFolder::frames_begun_apart_of(const Manifest& manifest) {
  for (const std::filesystem::path& part : parts_of(path_ / name_)) {
    if (!std::filesystem::exists(part / kManifestName)) continue;
    const Manifest begun = read_manifest(part);
    if (!first_difference(begun.header, manifest.header).empty() || !(begun.shard == manifest.shard))
      continue;
    apart_ = part;
    return hashes_of(begun);
  }
  return frames_of(manifest);
}

void SequenceFolder::build_apart() {
  remove_useless_parts();
  apart_ = fresh_part_name(path_ / name_);
}

void SequenceFolder::build_apart_from_earlier() {
  if (!files_of_sequence().empty()) build_apart();
}

void SequenceFolder::make() const { make_writable_folder(path()); }

void SequenceFolder::finish(Manifest manifest) {
  sync_file_system(path());
  if (is_apart()) put_in_place(manifest);
  save(manifest, path_);
}

/// What a process that was killed has built apart and no command goes on with: it has no manifest.
void SequenceFolder::remove_useless_parts() const {
  std::error_code ignored;
  for (const std::filesystem::path& part : parts_of(path_ / name_))
    if (std::filesystem::is_directory(part, ignored) && !std::filesystem::exists(part / kManifestName))
      std::filesystem::remove_all(part, ignored);
}

/// Where both names are links of one file, the rename does nothing and leaves both.
void SequenceFolder::move_here(const std::filesystem::path& file) const {
  std::filesystem::rename(file, path_ / file.filename());
  std::filesystem::remove(file);
}

/// Frames keep their hashes in the manifest, so that one of the earlier sequence is never taken for one of
/// the new.
void SequenceFolder::put_in_place(const Manifest& manifest) {
  Manifest incomplete = manifest;
  incomplete.complete = false;
  save(incomplete, path_);
  std::filesystem::remove(apart_ / kManifestName);
  std::set<std::string> kept{kManifestName};
  for (const auto& entry : std::filesystem::directory_iterator(apart_)) {
    kept.insert(entry.path().filename().string());
    move_here(entry.path());
  }
  for (const std::filesystem::path& file : files_of_sequence())
    if (!kept.contains(file.filename().string())) std::filesystem::remove(file);
  std::filesystem::remove(apart_);
  apart_.clear();
}

void SequenceFolder::give_up() const noexcept {
  std::error_code ignored;
  if (is_apart()) std::filesystem::remove_all(apart_, ignored);
}

void SequenceFolder::remove_parts() const noexcept {
  std::error_code ignored;
  std::vector<std::filesystem::path> parts;
  for (const auto& entry : std::filesystem::directory_iterator(path(), ignored)) {
    const std::string file = entry.path().filename().string();
    const bool is_ours = file.starts_with(name_ + "_") || file.starts_with(std::string(kManifestName) + ".");
    if (is_ours && is_part_name(file) && entry.is_regular_file(ignored)) parts.push_back(entry.path());
  }
  for (const std::filesystem::path& part : parts) std::filesystem::remove(part, ignored);
}

}  // namespace kerf
