#include "frames/diff/frame_pairs.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <system_error>

#include "core/files/whole_file.h"
#include "frames/diff/folder_listing.h"
#include "frames/sequence/manifest.h"
#include "frames/sequence/sidecar.h"

namespace kerf {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& path, const std::string& reason) {
  throw std::runtime_error("cannot compare " + path.string() + ": " + reason);
}

bool is_folder(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) refuse(path, "there is no such file or folder");
  if (error) refuse(path, error.message());
  return fs::is_directory(status);
}

void require_frames(const fs::path& folder, const FolderListing& listing) {
  if (listing.frames.empty() && listing.faults.empty())
    refuse(folder, "it holds no PNG file, or only hidden ones");
}

bool is_well_typed(const nlohmann::json& json) {
  if (!json.is_object() || !json.contains("frames") || !json["frames"].is_array()) return false;
  if (json.contains("complete") && !json["complete"].is_boolean()) return false;
  return std::ranges::all_of(json["frames"], [](const nlohmann::json& frame) {
    return frame.is_object() && frame.contains("file") && frame["file"].is_string();
  });
}

/// A manifest names the frames that must exist.
void check_manifest(const fs::path& path, PairedFrames& result) {
  const auto json = nlohmann::json::parse(read_whole_file(path), nullptr, false);
  if (!is_well_typed(json)) {
    result.faults.push_back(path.string() + " is no manifest of frames");
    return;
  }
  const fs::path folder = path.parent_path();
  std::set<std::string> names;
  for (const auto& frame : json["frames"]) {
    const std::string name = frame["file"];
    if (!names.insert(name).second)
      result.faults.push_back("'" + name + "' is named more than once by " + path.string());
    if (name.empty() || !fs::is_regular_file(folder / name))
      result.faults.push_back("'" + name + "' is not in " + folder.string() + ", though its " +
                              kManifestName + " names it");
  }
  if (!json.value("complete", true))
    result.notes.push_back(folder.string() + " holds a sequence that was not finished");
}

void take_faults(const FolderListing& listing, PairedFrames& result) {
  result.faults.insert(result.faults.end(), listing.faults.begin(), listing.faults.end());
  for (const auto& [name, manifest] : listing.manifests) check_manifest(manifest, result);
}

/// The ids and the draw list of a frame that is on both sides must be there on both or on none.
void add_beside(const FolderListing& references, const FolderListing& tests, FramePair& pair) {
  if (pair.is_missing() || pair.is_extra()) return;
  for (const fs::path& path : {ids_path(pair.name), draw_list_path(pair.name)}) {
    const std::string name = path.generic_string();
    const bool has_reference = references.beside.contains(name);
    if (has_reference == tests.beside.contains(name)) continue;
    pair.beside.push_back(path.filename().string() +
                          (has_reference ? " beside it is missing" : " beside it has no reference"));
  }
}

std::vector<FramePair> pair_by_name(const FolderListing& references, const FolderListing& tests) {
  std::map<std::string, FramePair> pairs;
  for (const auto& [name, path] : references.frames) pairs[name] = {name, path, {}};
  for (const auto& [name, path] : tests.frames) {
    pairs[name].name = name;
    pairs[name].test = path;
  }
  std::vector<FramePair> result;
  for (auto& [name, pair] : pairs) {
    add_beside(references, tests, pair);
    result.push_back(std::move(pair));
  }
  return result;
}

/// Of two files only these themselves are asked about.
void note_ids_of_one(const fs::path& reference, const fs::path& test, PairedFrames& result) {
  const auto has = [](const fs::path& frame) {
    return fs::exists(ids_path(frame)) && fs::exists(draw_list_path(frame));
  };
  if (has(reference) == has(test)) return;
  const fs::path& without = has(reference) ? test : reference;
  result.notes.push_back("there are no ids beside " + without.string() + ": only the pixels were compared");
}

/// A file against itself is the same, but that is hardly the question.
void note_one_and_the_same(const fs::path& reference, const fs::path& test, PairedFrames& result) {
  std::error_code ignored;
  if (fs::equivalent(reference, test, ignored))
    result.notes.push_back(reference.string() + " and " + test.string() + " are one and the same");
}

PairedFrames pair_folders(const fs::path& reference, const fs::path& test, bool may_lack_references) {
  const bool begins = may_lack_references && !fs::exists(reference);
  FolderListing references = begins ? FolderListing{} : list_folder(reference);
  FolderListing tests = list_folder(test);
  agree_on_beside(references, tests);
  if (!may_lack_references) require_frames(reference, references);
  require_frames(test, tests);
  PairedFrames result;
  result.frames = pair_by_name(references, tests);
  result.manifests = compare_manifests(references.manifests, tests.manifests);
  result.faults = compare_others(references.others, tests.others);
  take_faults(references, result);
  take_faults(tests, result);
  return result;
}

}  // namespace

PairedFrames pair_frames(const fs::path& reference, const fs::path& test, WithoutReferences without) {
  const bool accepts = without == WithoutReferences::accept;
  const bool begins = accepts && !fs::exists(reference);
  const bool folders = begins ? is_folder(test) : is_folder(reference);
  if (folders != is_folder(test)) {
    refuse(folders ? test : reference, "it is a file and " + (folders ? reference : test).string() +
                                           " is a folder; give two files or two folders");
  }
  PairedFrames result;
  if (folders) {
    result = pair_folders(reference, test, accepts);
  } else {
    result.frames.push_back({test.filename().string(), begins ? fs::path() : reference, test});
    if (!begins) note_ids_of_one(reference, test, result);
  }
  note_one_and_the_same(reference, test, result);
  return result;
}

}  // namespace kerf
