#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/recording/recording_info.h"
#include "frames/commands/command.h"
#include "frames/page/gnuplot.h"
#include "frames/study/join.h"
#include "frames/study/study_page.h"
#include "frames/study/study_run.h"
#include "frames/study/study_table.h"
#include "frames/support/atomic_file.h"
#include "frames/support/errors.h"
#include "frames/support/interrupt.h"
#include "frames/support/progress.h"
#include "frames/support/scratch_folder.h"
#include "frames/support/shard.h"
#include "frames/support/suggest.h"

namespace kerf {
namespace {

std::string describe(const std::vector<Failure>& failures, std::size_t asked) {
  std::string text = std::to_string(failures.size()) + " of " + std::to_string(asked) +
                     " cells could not be measured, the others are there:";
  for (const Failure& failure : failures) text += "\n  " + failure.id + ": " + failure.reason;
  return text;
}

/// The files of a joined study: all are there before one of them gets its name.
void write_joined(const Study& study, const JoinedStudy& joined, const std::filesystem::path& folder,
                  const std::string& command, Replace replace) {
  const StudyTable table = table_of(joined);
  PartFile csv(folder / "cells.csv", replace);
  csv.write(to_csv(table));
  PartFile sqlite(folder / "cells.sqlite", replace);
  write_sqlite(table, sqlite.path());
  PartFile page(folder / "index.html", replace);
  page.write(study_page(study, joined, command));
  csv.keep();
  sqlite.keep();
  page.keep();
}

class StudyCommand final : public Command {
 public:
  explicit StudyCommand(CLI::App& program);
  void run() const override;

 private:
  [[nodiscard]] std::vector<const StudyCell*> chosen_cells(const Study& study) const;
  [[nodiscard]] std::filesystem::path cells_folder(const Study& study) const;
  void list(const Study& study) const;
  void print_cells(const Study& study) const;
  void measure(const Study& study) const;
  void join_shards(const Study& study) const;

  std::string file_;
  std::string out_;
  std::string shard_;
  std::vector<std::string> cells_;
  std::vector<std::string> folders_;
  bool list_ = false;
  bool overwrite_ = false;
};

StudyCommand::StudyCommand(CLI::App& program)
    : Command(program, "study", "Measure a matrix of cells, on one machine or on many") {
  option("STUDY", file_, "The matrix, see below", "")->required();
  output("-o,--out", out_,
         "The folder of the cells (default out/STUDY); with --join that of the tables and the page", "DIR");
  auto* const shard = command_->add_option("--shard", shard_, "Only every N-th cell, the K-th first");
  shard->type_name("K/N");
  auto* const cells = command_->add_option(
      "--cell", cells_, "Only this cell; without --out its figures are printed and not kept");
  cells->type_name("ID")->excludes(shard);
  auto* const lists = command_->add_flag("--list", list_, "Print the cells, and which of them are there");
  auto* const joins =
      command_->add_option("--join", folders_, "Put together what is in the folders of all shards");
  joins->type_name("FOLDER")->excludes(shard)->excludes(cells)->excludes(lists);
  command_->add_flag("--overwrite", overwrite_, "Measure anew what is there; replace earlier tables");
  command_->footer(
      "A study is a JSON file with a list of matrices; every combination of their values is a cell:\n"
      "  {\"matrices\": [{\"motions\": [\"falling\"], \"dimensions\": [2, 3], \"objects\": [1000, 4000],\n"
      "                 \"seeds\": [1, 2, 3], \"broad_phases\": [\"kerf\", \"columns\"], \"repeats\": 5}]}\n"
      "docs/STUDIES.md has all keys. A cell that is there is not measured again: after an interruption the\n"
      "same command goes on. --join writes cells.csv, cells.sqlite and index.html.");
}

void StudyCommand::run() const {
  const Study study = read_study(file_);
  if (!folders_.empty()) return join_shards(study);
  if (list_) return list(study);
  if (!cells_.empty() && out_.empty()) {
    if (overwrite_)
      throw UsageError("--overwrite: without --out the figures of a cell are printed; give --out");
    return print_cells(study);
  }
  measure(study);
}

std::vector<const StudyCell*> StudyCommand::chosen_cells(const Study& study) const {
  const Shard shard = shard_.empty() ? Shard{} : parse_shard(shard_);
  std::vector<std::string> ids;
  for (const StudyCell& cell : study.cells) ids.push_back(cell.id);
  for (const std::string& id : cells_)
    if (std::ranges::find(ids, id) == ids.end())
      throw UsageError("--cell '" + id + "' is no cell of " + study.file + "; --list prints them");
  std::vector<const StudyCell*> chosen;
  for (std::size_t k = 0; k < study.cells.size(); ++k) {
    const bool named = cells_.empty() || std::ranges::find(cells_, ids[k]) != cells_.end();
    if (named && shard.has(k)) chosen.push_back(&study.cells[k]);
  }
  return chosen;
}

std::filesystem::path StudyCommand::cells_folder(const Study& study) const {
  return out_.empty() ? std::filesystem::path("out") / study.name : std::filesystem::path(out_);
}

void StudyCommand::list(const Study& study) const {
  const std::filesystem::path folder = cells_folder(study);
  const std::vector<const StudyCell*> cells = chosen_cells(study);
  std::size_t missing = 0;
  for (const StudyCell* const cell : cells) {
    const bool is_there = read_cell_file(cell_path(folder, *cell), *cell).has_value();
    missing += is_there ? 0 : 1;
    std::printf("%s  %s\n", cell->id.c_str(), is_there ? "there" : "missing");
  }
  if (missing > 0)
    throw DoesNotHold(std::to_string(missing) + " of " + std::to_string(cells.size()) + " cells are missing");
}

void StudyCommand::print_cells(const Study& study) const {
  const InterruptGuard interrupt;
  const ScratchFolder frames;
  for (const StudyCell* const cell : chosen_cells(study)) {
    StudyResult result =
        measure_apart(*cell, frames.path(), Replace::nothing, [&] { return interrupt.requested(); });
    if (interrupt.requested()) throw Interrupted("interrupted");
    if (!result.trouble.empty()) throw DoesNotHold(describe({{cell->id, result.trouble}}, 1));
    std::fputs(to_json(make_cell_file(study, *cell, std::move(result.figures))).c_str(), stdout);
  }
}

void StudyCommand::measure(const Study& study) const {
  const std::filesystem::path folder = cells_folder(study);
  const auto asked = chosen_cells(study);
  Outputs outputs({study.file}, overwrite_);
  outputs.add_folder(folder);
  const auto cells = cells_to_do(asked, folder, overwrite_);
  make_writable_folder(folder);
  std::vector<Failure> failures;
  {
    const InterruptGuard interrupt;
    Countdown countdown(cells.size(), static_cast<double>(cells.size()));
    failures = run_cells(
        study, cells, folder, outputs.replace(),
        {[&](const StudyCell& cell) { countdown.begin(cell.id, 1); }, [&] { return interrupt.requested(); }});
  }
  if (!failures.empty()) throw DoesNotHold(describe(failures, asked.size()));
  std::printf("%s: %zu of %zu cells are in %s, %zu of them new\n", study.name.c_str(), asked.size(),
              study.cells.size(), folder.c_str(), cells.size());
}

void StudyCommand::join_shards(const Study& study) const {
  if (out_.empty()) throw UsageError("--join needs a folder for what it writes: give one with --out");
  const std::filesystem::path folder = out_;
  const std::vector<std::filesystem::path> shards(folders_.begin(), folders_.end());
  std::vector<std::filesystem::path> inputs = shards;
  inputs.emplace_back(study.file);
  Outputs outputs(inputs, overwrite_);
  outputs.add_folder(folder);
  for (const char* const name : {"cells.csv", "cells.sqlite", "index.html"}) outputs.add_file(folder / name);
  const JoinedStudy joined = join(study, shards);
  if (joined.cells.empty()) throw DoesNotHold("none of the cells of " + study.file + " is there");
  require_gnuplot();
  make_writable_folder(folder);
  std::string command = "kerf study " + study.file + " --join";
  for (const std::string& shard : folders_) command += " " + shard;
  write_joined(study, joined, folder, command + " --out " + out_, outputs.replace());
  for (const auto& sequence : gather_frames(joined, folder, overwrite_))
    std::printf("%s: all frames\n", sequence.c_str());
  std::printf("%s: %zu of %zu cells, counts %s\n", folder.c_str(), joined.cells.size(), study.cells.size(),
              to_hex(counts_hash(joined)).c_str());
  if (joined.doubles > 0) std::printf("%zu are there more than once, with equal counts\n", joined.doubles);
  if (joined.strangers > 0) std::printf("%zu files are of no cell of the study\n", joined.strangers);
  const std::string missing = describe_missing(study, joined);
  if (!missing.empty()) throw DoesNotHold(missing);
}

}  // namespace

AnyCommand make_study_command(CLI::App& program) { return std::make_unique<StudyCommand>(program); }

}  // namespace kerf
