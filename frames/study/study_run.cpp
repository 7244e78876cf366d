#include "frames/study/study_run.h"

#include <chrono>
#include <cstring>
#include <stdexcept>

#include "frames/support/atomic_file.h"
#include "frames/support/child_process.h"
#include "frames/support/errors.h"
#include "frames/support/shared_memory.h"

namespace kerf {
namespace {

/// What a child writes for its parent: a text that ends with a zero.
class Letter {
 public:
  void write(const std::string& text) const {
    if (text.size() >= memory_.size()) throw std::logic_error("the figures of a cell are too long");
    std::memcpy(memory_.data(), text.c_str(), text.size() + 1);
  }
  [[nodiscard]] std::string text() const { return reinterpret_cast<const char*>(memory_.data()); }

 private:
  SharedMemory memory_{std::size_t{64} << 10U};
};

std::string interruption(std::size_t done, std::size_t all, const std::filesystem::path& folder) {
  return "interrupted; " + std::to_string(done) + " of " + std::to_string(all) + " cells are kept in " +
         folder.string() + ", and the same command goes on from there";
}

}  // namespace

StudyResult measure_apart(const StudyCell& cell, const std::filesystem::path& folder, Replace replace,
                          const std::function<bool()>& stop) {
  const Letter letter;
  ChildProcess child([&](char) {
    const Figures figures = std::visit(
        [&](const auto& work) { return measure(work, frames_path(folder, cell), replace); }, cell.work);
    letter.write(Json{figures.counts, figures.times}.dump());
  });
  if (!child.ask(' ', std::chrono::duration<double>(cell.patience), stop)) return {{}, child.trouble()};
  const Json figures = Json::parse(letter.text());
  return {{figures[0], figures[1]}, ""};
}

std::vector<const StudyCell*> cells_to_do(const std::vector<const StudyCell*>& cells,
                                          const std::filesystem::path& folder, bool overwrite) {
  std::vector<const StudyCell*> found;
  for (const StudyCell* const cell : cells) {
    const std::filesystem::path file = cell_path(folder, *cell);
    if (!overwrite && read_cell_file(file, *cell)) continue;
    // The rest of its pictures is kept, and so is its file when all are there again.
    if (overwrite || lost_picture(file, *cell).empty()) Outputs({}, overwrite).add_file(file);
    found.push_back(cell);
  }
  return found;
}

std::vector<Failure> run_cells(const Study& study, const std::vector<const StudyCell*>& cells,
                               const std::filesystem::path& folder, Replace replace,
                               const StudyWatch& watch) {
  std::vector<Failure> failures;
  std::size_t done = 0;
  for (const StudyCell* const cell : cells) {
    if (watch.stop()) throw Interrupted(interruption(done, cells.size(), folder));
    const std::filesystem::path path = cell_path(folder, *cell);
    const auto is_done = [&] { return replace == Replace::nothing && read_cell_file(path, *cell); };
    watch.begin(*cell);
    if (is_done()) continue;
    StudyResult result = measure_apart(*cell, folder, replace, watch.stop);
    if (!result.trouble.empty()) {
      if (watch.stop()) throw Interrupted(interruption(done, cells.size(), folder));
      failures.push_back({cell->id, result.trouble});
      continue;
    }
    ++done;
    if (is_done()) continue;  // another process has the same cells, and was faster
    const CellFile file = make_cell_file(study, *cell, std::move(result.figures));
    try {
      write_file_atomically(path, to_json(file), replace);
    } catch (const std::runtime_error&) {
      if (!is_done()) throw;  // faster by less than a write takes
    }
  }
  return failures;
}

}  // namespace kerf
