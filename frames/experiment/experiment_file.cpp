#include "frames/experiment/experiment_file.h"

#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

#include "frames/experiment/related.h"
#include "frames/support/atomic_file.h"
#include "frames/support/errors.h"
#include "frames/support/parse_number.h"
#include "frames/support/version.h"

namespace kerf {
namespace {

constexpr const char* kColumns =
    "step,moving,broad_phase,fps,pairs,candidates,collision_ms,overhead_ms,depth,leaves,operators,wrong,"
    "contacts,rest_ms";

constexpr const char* kTitle = "# kerf experiment";

/// The first line, which identifies a file's format, simulation, size and run, and the program that made it:
/// the times of two builds are no samples of one experiment.
std::string title(const RunId& run) {
  const Simulation& simulation = simulations()[run.simulation];
  return kTitle + std::string(run.kind == RunKind::related ? " of related work" : "") +
         std::string(" 5, simulation ") + std::to_string(simulation.number) + " (" +
         std::string(simulation.scene) + "), steps " + std::to_string(run.size.steps) + ", objects " +
         std::to_string(run.size.objects) + ", seed " + std::to_string(run.size.seed) + ", repeat " +
         std::to_string(run.repeat) + ", build " + build_id();
}

/// "simulation-1-terrain".
std::string file_stem(const Simulation& simulation) {
  return "simulation-" + std::to_string(simulation.number) + "-" + std::string(simulation.scene);
}

void write_step(std::ostream& text, const ExperimentStep& row, std::span<const std::string_view> names) {
  for (std::size_t k = 0; k < row.contestants.size(); ++k) {
    const ContestantStep& one = row.contestants[k];
    text << row.step << ',' << row.moving << ',' << names[k] << ',' << row.fps(k) << ',' << row.pairs << ',';
    if (one.candidates >= 0) text << static_cast<std::uint64_t>(one.candidates);
    text << ',' << one.collision << ',' << one.update << ',';
    if (one.leaves > 0)
      text << one.height << ',' << one.leaves << ',' << one.operators;
    else
      text << ",,";
    text << ',' << one.wrong << ',' << row.contacts << ',' << row.rest << '\n';
  }
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream text(line + ",");
  for (std::string cell; std::getline(text, cell, ',');) cells.push_back(cell);
  return cells;
}

/// Throws std::invalid_argument for anything but a number from 0 on, and not without end.
template <class Number>
Number number_in(const std::string& cell) {
  const auto number = parse_number<Number>(cell);
  if (!number || !std::isfinite(static_cast<double>(*number)))
    throw std::invalid_argument("not a number of an experiment");
  return *number;
}

template <class Number>
Number number_or_0(const std::string& cell) {
  return cell.empty() ? 0 : number_in<Number>(cell);
}

/// Adds a line to its step, which has a line for each of the names. Throws std::invalid_argument for one that
/// is none, or of another step.
void read_line(const std::string& line, std::span<const std::string_view> names, ExperimentRun& run) {
  const std::vector<std::string> cells = cells_of(line);
  const std::size_t contestant = run.empty() ? 0 : run.back().contestants.size() % names.size();
  if (cells.size() != 14 || cells[2] != names[contestant])
    throw std::invalid_argument("not a line of an experiment");
  if (contestant == 0) {
    ExperimentStep& row = run.emplace_back();
    row.step = number_in<std::uint32_t>(cells[0]);
    row.moving = number_in<std::uint32_t>(cells[1]);
    row.pairs = number_in<std::uint64_t>(cells[4]);
    row.contacts = number_in<std::uint64_t>(cells[12]);
    row.rest = number_in<double>(cells[13]);
  }
  if (number_in<std::uint32_t>(cells[0]) != run.size())
    throw std::invalid_argument("not the next step of an experiment");
  ContestantStep one;
  if (!cells[5].empty()) one.candidates = number_in<double>(cells[5]);
  one.collision = number_in<double>(cells[6]);
  one.update = number_in<double>(cells[7]);
  one.height = number_or_0<std::uint32_t>(cells[8]);
  one.leaves = number_or_0<std::uint32_t>(cells[9]);
  one.operators = number_or_0<std::uint64_t>(cells[10]);
  one.wrong = number_in<std::uint64_t>(cells[11]);
  run.back().contestants.push_back(one);
}

}  // namespace

std::string name_of(const RunId& run) {
  const Simulation& simulation = simulations()[run.simulation];
  return "simulation " + std::to_string(simulation.number) + " (" + std::string(simulation.scene) +
         "), seed " + std::to_string(run.size.seed) + ", repeat " + std::to_string(run.repeat);
}

Lineup lineup_of(const RunId& run) {
  if (run.kind == RunKind::related) return {related_contestants(), true};
  return {contestants_in(run.repeat), run.repeat == 1};
}

std::filesystem::path run_path(const std::filesystem::path& folder, const RunId& run) {
  return folder /
         ((run.kind == RunKind::related ? "related-" : "") + file_stem(simulations()[run.simulation]) +
          "-seed-" + std::to_string(run.size.seed) + "-repeat-" + std::to_string(run.repeat) + ".csv");
}

void save_run(const std::filesystem::path& folder, const RunId& run, const ExperimentRun& steps) {
  std::ostringstream text;
  text << title(run) << '\n' << kColumns << '\n';
  for (const ExperimentStep& row : steps) write_step(text, row, lineup_of(run).names);
  write_file_atomically(run_path(folder, run), text.str());
}

std::optional<ExperimentRun> load_run(const std::filesystem::path& folder, const RunId& id, bool forget) {
  const std::filesystem::path path = run_path(folder, id);
  std::ifstream file(path);
  if (!file) return std::nullopt;
  std::string line;
  std::getline(file, line);
  if (line.empty()) throw std::runtime_error(path.string() + " is empty; remove it, and the run is made");
  const bool is_of_another = line != title(id);
  if (forget && is_of_another && line.starts_with(kTitle)) return std::nullopt;
  if (is_of_another)
    throw UsageError(path.string() +
                     " is of another experiment, or of another build of kerf; choose another folder with "
                     "--out, or replace it with --overwrite");
  const std::span<const std::string_view> names = lineup_of(id).names;
  ExperimentRun run;
  try {
    std::getline(file, line);
    if (line != kColumns) throw std::invalid_argument("not the columns of an experiment");
    while (std::getline(file, line)) read_line(line, names, run);
  } catch (const std::logic_error&) {
    run.clear();
  }
  if (run.size() != id.size.steps || run.back().contestants.size() != names.size())
    throw std::runtime_error(path.string() + " is damaged; remove it, and the run is made again");
  return run;
}

void refuse_earlier_files(const std::filesystem::path& folder) {
  for (const Simulation& simulation : simulations()) {
    const std::filesystem::path path = folder / (file_stem(simulation) + ".csv");
    if (std::filesystem::exists(path))
      throw UsageError(path.string() +
                       " is of an earlier kerf, which ran each simulation once; choose another folder with "
                       "--out, or leave it as it is with --overwrite");
  }
}

}  // namespace kerf
