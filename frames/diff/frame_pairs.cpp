#include "frames/diff/frame_pairs.h"

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <system_error>

#include "frames/sequence/manifest.h"
#include "frames/sequence/sidecar.h"
#include "frames/support/errors.h"

namespace kerf {
namespace {

namespace fs = std::filesystem;
using FilesByName = std::map<std::string, fs::path>;

[[noreturn]] void refuse(const fs::path& path, const std::string& reason) {
  throw UnusableInput("cannot compare " + path.string() + ": " + reason);
}

bool is_folder(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) refuse(path, "there is no such file or folder");
  if (error) refuse(path, error.message());
  return fs::is_directory(status);
}

bool is_frame(const fs::path& path) {
  const std::string name = path.filename().string();
  return path.extension() == ".png" && !name.starts_with(".") && !is_sidecar(path);
}

FilesByName find_frames(const fs::path& folder) {
  FilesByName names;
  std::error_code error;
  for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    if (entry->is_regular_file() && is_frame(entry->path()))
      names.emplace(entry->path().lexically_relative(folder).generic_string(), entry->path());
  }
  if (error) refuse(folder, error.message());
  return names;
}

FilesByName find_some_frames(const fs::path& folder) {
  FilesByName names = find_frames(folder);
  if (names.empty()) refuse(folder, "it holds no PNG file");
  return names;
}

/// A manifest tells of frames that should be there.
void check_manifest(const fs::path& folder, const FilesByName& names, PairedFrames& result) {
  std::ifstream file(folder / kManifestName);
  if (!file) return;
  const auto json = nlohmann::json::parse(file, nullptr, false);
  if (!json.is_object() || !json.contains("frames") || !json["frames"].is_array()) {
    result.faults.push_back((folder / kManifestName).string() + " is no manifest of frames");
    return;
  }
  for (const auto& frame : json["frames"]) {
    const std::string name = frame.is_object() ? frame.value("file", "") : "";
    if (!names.contains(name))
      result.faults.push_back("'" + name + "' is not in " + folder.string() + ", though its " +
                              kManifestName + " names it");
  }
  if (!json.value("complete", true))
    result.notes.push_back(folder.string() + " holds a sequence that was not finished");
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
  if (!folders) {
    result.frames.push_back({test.filename().string(), begins ? fs::path() : reference, test});
    return result;
  }
  const FilesByName references = begins    ? FilesByName()
                                 : accepts ? find_frames(reference)
                                           : find_some_frames(reference);
  const FilesByName tests = find_some_frames(test);
  std::map<std::string, FramePair> pairs;
  for (const auto& [name, path] : references) pairs[name] = {name, path, {}};
  for (const auto& [name, path] : tests) {
    pairs[name].name = name;
    pairs[name].test = path;
  }
  for (const auto& [name, pair] : pairs) result.frames.push_back(pair);
  check_manifest(reference, references, result);
  check_manifest(test, tests, result);
  return result;
}

}  // namespace kerf
