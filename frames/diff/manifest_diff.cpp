#include "frames/diff/manifest_diff.h"

#include <map>
#include <set>

#include "core/files/whole_file.h"
#include "frames/page/json.h"

namespace kerf {
namespace {

/// "config.merge: 1 and 0" for the first of them that differs; empty if none does.
std::string difference(const Json& a, const Json& b, const std::set<std::string>& left_out = {}) {
  const auto text = [](const Json& json, const std::string& key) {
    return json.contains(key) ? json_text(json[key], -1) : "nothing";
  };
  for (const Json* const json : {&a, &b}) {
    for (const auto& [key, value] : json->items()) {
      if (left_out.contains(key) || (a.contains(key) && b.contains(key) && a[key] == b[key])) continue;
      const bool goes_on = a.contains(key) && b.contains(key) && a[key].is_object() && b[key].is_object();
      if (!goes_on) return key + ": " + text(a, key) + " and " + text(b, key);
      const std::string inside = difference(a[key], b[key], left_out);
      if (!inside.empty()) return key + "." + inside;
    }
  }
  return "";
}

using FramesByFile = std::map<std::string, Json>;

/// The frames by their files. What is no manifest has none, and is refused elsewhere.
FramesByFile frames_of(const Json& manifest) {
  FramesByFile frames;
  for (const Json& frame : manifest["frames"])
    if (frame.is_object() && frame.contains("file") && frame["file"].is_string())
      frames.emplace(frame["file"].get<std::string>(), frame);
  return frames;
}

/// "a.png and 2 more" for those that the other one does not have.
std::string only_in(const FramesByFile& frames, const FramesByFile& others) {
  std::string first;
  std::size_t count = 0;
  for (const auto& [file, frame] : frames) {
    if (others.contains(file)) continue;
    if (count++ == 0) first = file;
  }
  return first + (count > 1 ? " and " + std::to_string(count - 1) + " more" : "");
}

/// The first frame that shows something else, and how many do.
std::string other_frames(const FramesByFile& reference, const FramesByFile& test) {
  std::string first;
  std::size_t count = 0;
  for (const auto& [file, frame] : reference) {
    const auto partner = test.find(file);
    if (partner == test.end()) continue;
    const std::string how = difference(frame, partner->second, {"pixel_hash"});
    if (!how.empty() && count++ == 0) first = file + ": " + how;
  }
  return first + (count > 1 ? "; so do " + std::to_string(count - 1) + " more of its frames" : "");
}

bool is_manifest(const Json& json) {
  return json.is_object() && json.contains("frames") && json["frames"].is_array();
}

std::vector<std::string> compare(const std::filesystem::path& reference, const std::filesystem::path& test) {
  const Json a = Json::parse(read_whole_file(reference), nullptr, false);
  const Json b = Json::parse(read_whole_file(test), nullptr, false);
  if (!is_manifest(a) || !is_manifest(b)) return {};
  std::vector<std::string> reasons;
  const auto add = [&reasons](const std::string& before, const std::string& what) {
    if (!what.empty()) reasons.push_back(before + what);
  };
  // A run that was recorded anew is another recording, of which the same is asked.
  add("", difference(a, b, {"shard", "complete", "frames", "identity"}));
  const FramesByFile of_a = frames_of(a);
  const FramesByFile of_b = frames_of(b);
  add("it does not name ", only_in(of_a, of_b));
  add("its reference does not name ", only_in(of_b, of_a));
  add("", other_frames(of_a, of_b));
  return reasons;
}

}  // namespace

std::vector<ManifestDiff> compare_manifests(const FilesByName& reference, const FilesByName& test) {
  std::vector<ManifestDiff> result;
  for (const auto& [name, path] : reference) {
    const auto partner = test.find(name);
    if (partner == test.end()) {
      result.push_back({name, path, {}, {"it is missing"}});
      continue;
    }
    std::vector<std::string> reasons = compare(path, partner->second);
    if (!reasons.empty()) result.push_back({name, path, partner->second, std::move(reasons)});
  }
  for (const auto& [name, path] : test)
    if (!reference.contains(name)) result.push_back({name, {}, path, {"it has no reference"}});
  return result;
}

}  // namespace kerf
