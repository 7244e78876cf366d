#include "frames/study/cell_file.h"

#include <algorithm>
#include <initializer_list>
#include <stdexcept>
#include <utility>

#include "core/files/whole_file.h"
#include "frames/page/json.h"
#include "frames/support/machine.h"
#include "frames/support/version.h"

namespace kerf {
namespace {

constexpr const char* kCellFormat = "kerf-cell-1";

bool is_cell(const Json& json) {
  if (!json.is_object() || json.value("format", Json()) != kCellFormat) return false;
  for (const char* const key : {"id", "machine", "command"})
    if (!json.contains(key) || !json[key].is_string()) return false;
  for (const char* const key : {"cell", "counts", "times"})
    if (!json.contains(key) || !json[key].is_object()) return false;
  return true;
}

/// Whether all are there that the cell measures.
bool has_figures(const Figures& figures, const StudyCell& cell) {
  using Names = std::initializer_list<const char*>;
  const auto knows = [](const Json& json, Names names) {  // of what some broad phases have none
    return std::ranges::all_of(names, [&](const char* name) { return json.contains(name); });
  };
  const auto has = [](const Json& json, Names names) {
    return std::ranges::none_of(names, [&](const char* name) { return json.value(name, Json()).is_null(); });
  };
  const auto& [counts, times] = figures;
  if (cell.is_frames()) return has(counts, {"frames", "pixels_hash"}) && has(times, {"total_ms"});
  const Measures& asked = std::get<RunCell>(cell.work).measures;
  if ((asked.counts || asked.errors) && !has(counts, {"bodies", "pairs", "pairs_hash"})) return false;
  if (asked.counts && !knows(counts, {"candidates", "leaves", "height", "entries", "operators"}))
    return false;
  if (asked.errors && !has(counts, {"missed", "extra"})) return false;
  return !asked.times ||
         (has(times, {"total_ms", "median_ms", "worst_ms"}) && knows(times, {"overhead_ms", "collision_ms"}));
}

/// The file of that cell, wherever its pictures are.
std::optional<CellFile> read_figures(const std::filesystem::path& file, const StudyCell& cell) {
  auto found = read_cell_file(file);
  if (found && (found->id != cell.id || !is_equal(found->settings, cell.settings) ||
                !has_figures(found->figures, cell)))
    return std::nullopt;
  return found;
}

/// Empty also if the manifest cannot be read: who reads the pictures says so.
std::string first_lost(const std::filesystem::path& out, const StudyCell& cell) {
  if (!cell.is_frames()) return "";
  const std::filesystem::path folder = frames_path(out, cell);
  if (!std::filesystem::exists(folder / kManifestName)) return kManifestName;
  try {
    for (const FrameRecord& frame : read_manifest(folder).frames)
      if (!std::filesystem::exists(folder / frame.file)) return frame.file;
  } catch (const std::runtime_error&) {
    return "";
  }
  return "";
}

}  // namespace

std::filesystem::path cell_path(const std::filesystem::path& folder, const StudyCell& cell) {
  return folder / (cell.id + ".json");
}

std::filesystem::path frames_path(const std::filesystem::path& folder, const StudyCell& cell) {
  return folder / cell.id;
}

CellFile make_cell_file(const Study& study, const StudyCell& cell, Figures figures) {
  return {cell.id, cell.settings, std::move(figures),
          describe_machine().value("processor", "unknown") + ", kerf " + version(),
          "kerf study " + study.file + " --cell " + cell.id};
}

std::string to_json(const CellFile& file) {
  constexpr int kIndent = 1;
  return json_text(Json{{"format", kCellFormat},
                        {"id", file.id},
                        {"cell", file.settings},
                        {"counts", file.figures.counts},
                        {"times", file.figures.times},
                        {"machine", file.machine},
                        {"command", file.command}},
                   kIndent) +
         "\n";
}

bool is_equal(const Json& a, const Json& b) { return nlohmann::json(a) == nlohmann::json(b); }

std::optional<CellFile> read_cell_file(const std::filesystem::path& file) {
  const auto text = read_whole_file_if_there(file);
  if (!text) return std::nullopt;
  const Json json = Json::parse(*text, nullptr, false);
  if (!is_cell(json)) return std::nullopt;
  return CellFile{
      json["id"], json["cell"], {json["counts"], json["times"]}, json["machine"], json["command"]};
}

std::optional<CellFile> read_cell_file(const std::filesystem::path& file, const StudyCell& cell) {
  auto found = read_figures(file, cell);
  if (found && !first_lost(file.parent_path(), cell).empty()) return std::nullopt;
  return found;
}

std::string lost_picture(const std::filesystem::path& file, const StudyCell& cell) {
  return read_figures(file, cell) ? first_lost(file.parent_path(), cell) : "";
}

}  // namespace kerf
