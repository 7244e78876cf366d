#include "frames/study/join.h"

#include <map>
#include <stdexcept>
#include <utility>

#include "core/recording/chain.h"
#include "frames/sequence/collection.h"
#include "frames/support/errors.h"
#include "viz/image/png.h"

namespace kerf {
namespace {

constexpr std::size_t kMostNamed = 8;

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& what, const StudyCell& cell) {
  throw std::runtime_error(path.string() + " " + what + "; measure it again: kerf study with --cell " +
                           cell.id + ", --out " + path.parent_path().string() + " and --overwrite");
}

/// The file of the cell says what its manifest said, and the manifest what was drawn.
void check_pictures(const JoinedStudy::Cell& found) {
  const std::filesystem::path folder = frames_path(found.folder, *found.cell);
  const auto can_be_read = [&](const std::string& file, auto read) {
    try {
      return read(file);
    } catch (const std::runtime_error&) {
      refuse(folder, "has a file that cannot be read, " + file, *found.cell);
    }
  };
  const Manifest manifest =
      can_be_read(kManifestName, [&](const std::string&) { return read_manifest(folder); });
  if (!is_equal(counts_of(manifest), found.file.figures.counts))
    refuse(folder, "has not the frames that its cell counted", *found.cell);
  for (const FrameRecord& frame : manifest.frames) {
    const Image image =
        can_be_read(frame.file, [&](const std::string& file) { return read_png(folder / file); });
    if (pixel_hash(image) != frame.pixel_hash)
      refuse(folder, "has another picture than was drawn, " + frame.file, *found.cell);
  }
}

/// "a, b, c and 12 more"
std::string list_of(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t k = 0; k < std::min(names.size(), kMostNamed); ++k)
    text += (k == 0 ? "" : ", ") + names[k];
  if (names.size() > kMostNamed) text += " and " + std::to_string(names.size() - kMostNamed) + " more";
  return text;
}

class Joiner {
 public:
  explicit Joiner(const Study& study) {
    for (const StudyCell& cell : study.cells) cells_.emplace(cell.id, &cell);
  }

  void add(const std::filesystem::path& folder) {
    if (!std::filesystem::is_directory(folder)) throw UsageError(folder.string() + " is no folder");
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      if (entry.path().extension() == ".json") add_file(entry.path(), folder);
  }
  JoinedStudy finish(const Study& study) {
    if (!differences_.empty())
      throw std::runtime_error("different counts of the same cells: " + list_of(differences_) +
                               "; they must be equal: measure them again with the command in each file");
    for (const StudyCell& cell : study.cells) {
      const auto found = found_.find(cell.id);
      if (found == found_.end())
        joined_.missing.push_back(&cell);
      else
        joined_.cells.push_back(std::move(found->second));
    }
    for (const JoinedStudy::Cell& cell : joined_.cells)
      if (cell.cell->is_frames()) check_pictures(cell);
    for (const JoinedStudy::Cell& cell : doubles_)
      if (cell.cell->is_frames()) check_pictures(cell);
    return std::move(joined_);
  }

 private:
  void add_file(const std::filesystem::path& path, const std::filesystem::path& folder) {
    const auto known = cells_.find(path.stem().string());
    if (known == cells_.end()) {
      joined_.strangers += read_cell_file(path) ? 1U : 0U;
      return;
    }
    const StudyCell& cell = *known->second;
    auto file = read_cell_file(path, cell);
    if (!file) {
      const std::string lost = lost_picture(path, cell);
      if (lost.empty()) refuse(path, "is damaged", cell);
      refuse(frames_path(folder, cell), "lacks " + lost, cell);
    }
    const auto [earlier, is_new] = found_.try_emplace(cell.id);
    if (is_new) {
      earlier->second = {&cell, std::move(*file), folder};
    } else if (is_equal(earlier->second.file.figures.counts, file->figures.counts)) {
      ++joined_.doubles;
      doubles_.push_back({&cell, std::move(*file), folder});
    } else {
      differences_.push_back(cell_path(earlier->second.folder, cell).string() + " and " + path.string());
    }
  }

  std::map<std::string, const StudyCell*> cells_;
  std::map<std::string, JoinedStudy::Cell> found_;
  std::vector<JoinedStudy::Cell> doubles_;
  std::vector<std::string> differences_;
  JoinedStudy joined_;
};

}  // namespace

JoinedStudy join(const Study& study, const std::vector<std::filesystem::path>& folders) {
  Joiner joiner(study);
  for (const std::filesystem::path& folder : folders) joiner.add(folder);
  return joiner.finish(study);
}

std::string describe_missing(const Study& study, const JoinedStudy& joined) {
  if (joined.missing.empty()) return "";
  std::vector<std::string> ids;
  for (const StudyCell* const cell : joined.missing) ids.push_back(cell->id);
  return std::to_string(ids.size()) + " of " + std::to_string(study.cells.size()) +
         " cells are missing: " + list_of(ids) + "; `kerf study " + study.file +
         "` with the folder of the others as --out makes them, and with --list names them all";
}

std::uint64_t counts_hash(const JoinedStudy& joined) {
  std::uint64_t hash = 0;
  for (const JoinedStudy::Cell& cell : joined.cells) {
    const std::string text = nlohmann::json{cell.file.settings, cell.file.figures.counts}.dump();
    hash = hash_bytes({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, hash);
  }
  return hash;
}

std::vector<std::filesystem::path> gather_frames(const JoinedStudy& joined,
                                                 const std::filesystem::path& folder, bool overwrite) {
  // The parts of a sequence have equal settings but for the part.
  std::map<std::string, std::vector<std::filesystem::path>> parts;
  const auto sequence_of = [](const StudyCell& cell) {
    Json settings = cell.settings;
    settings.erase("part");
    return settings.dump();
  };
  for (const JoinedStudy::Cell& cell : joined.cells)
    if (cell.cell->is_frames())
      parts[sequence_of(*cell.cell)].push_back(frames_path(cell.folder, *cell.cell));
  for (const StudyCell* const cell : joined.missing) parts.erase(sequence_of(*cell));
  std::vector<std::filesystem::path> made;
  for (const auto& [settings, folders] : parts) {
    const Collection collection = collect(folders);
    const std::string gaps = describe_gaps(collection);
    if (!gaps.empty()) throw std::runtime_error(gaps);
    std::filesystem::path place = folder / collection.manifest.name;
    while (std::find(made.begin(), made.end(), place) != made.end()) place += "-";
    gather(collection, place, overwrite);
    made.push_back(place);
  }
  return made;
}

}  // namespace kerf
