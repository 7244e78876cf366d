#include "frames/commands/experiment_command.h"

#include <CLI/CLI.hpp>
#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <vector>

#include "core/base/counted.h"
#include "frames/commands/output_option.h"
#include "frames/experiment/experiment_file.h"
#include "frames/experiment/experiment_page.h"
#include "frames/experiment/experiment_plan.h"
#include "frames/experiment/experiment_plots.h"
#include "frames/experiment/related.h"
#include "frames/page/gnuplot.h"
#include "frames/support/atomic_file.h"
#include "frames/support/countdown.h"
#include "frames/support/errors.h"
#include "frames/support/interrupt.h"
#include "frames/support/outputs.h"
#include "frames/support/parse_whole.h"
#include "frames/support/shard.h"

namespace kerf {
namespace {

constexpr const char* kTextName = "experiment.md";
constexpr const char* kPageName = "experiment.html";
constexpr const char* kRelatedName = "related.html";
constexpr ExperimentPlan kFullPlan{.size = {.steps = 6000, .objects = 4250}, .seeds = 3, .repeats = 5};

/// Makes the runs of a shard of which there is no file yet.
class Experiment {
 public:
  Experiment(std::filesystem::path folder, const ExperimentPlan& plan, const Shard& shard, Replace replace)
      : folder_(std::move(folder)), plan_(plan), shard_(shard), replace_(replace) {
    const bool forget = replace == Replace::earlier;
    if (!forget) refuse_earlier_files(folder_);
    for (std::uint32_t repeat = 1; repeat <= plan.repeats; ++repeat)
      for (std::uint32_t k = 0; k < plan.seeds; ++k)
        for (std::size_t simulation = 0; simulation < runs_.size(); ++simulation)
          load(simulation, plan.with_seed(k), repeat, forget);
    make_writable_folder(folder_);
  }

  void run() {
    const InterruptGuard interrupt;
    for (const Place& place : missing_) {
      const Simulation& simulation = simulations()[place.simulation];
      TimedRun& run = runs_[place.simulation][place.index];
      const ExperimentSize size = plan_.with_seed(static_cast<std::uint32_t>(run.seed - plan_.size.seed));
      run.steps = run_simulation(simulation, size, cast_of(run.repeat), [&](std::uint32_t step) {
        show(simulation, run, step);
        return !interrupt.requested();
      });
      if (interrupt.requested()) throw Interrupted(interruption());
      save_run(folder_, simulation, size, run.repeat, run.steps);
      ++done_;
    }
  }

  [[nodiscard]] std::string shard_words(const std::string& shard) const {
    return counted(done_, "run") + " of shard " + shard + " made in " + folder_.string() +
           "; when all shards are there, the same command without --shard writes the pages";
  }

  /// All files are there before one of them gets its name.
  void report() const {
    const InterruptGuard interrupt;
    std::array<std::unique_ptr<PartFile>, kFigureNames.size()> figures;
    std::array<std::filesystem::path, kFigureNames.size()> files;
    for (std::size_t k = 0; k < figures.size(); ++k) {
      figures[k] = std::make_unique<PartFile>(folder_ / kFigureNames[k], replace_);
      files[k] = figures[k]->path();
    }
    PartFile text(folder_ / kTextName, replace_);
    PartFile page(folder_ / kPageName, replace_);
    text.write(experiment_text(plan_, runs_));
    try {
      plot_experiment(files, runs_);
      page.write(experiment_page(plan_, runs_));
    } catch (const std::runtime_error&) {
      if (!interrupt.requested()) throw;  // an interrupt stops gnuplot, too
    }
    if (interrupt.requested())
      throw Interrupted("interrupted: the simulations are in " + folder_.string() +
                        "; the same command draws the figures");
    for (const auto& figure : figures) figure->keep();
    text.keep();
    page.keep();
  }

 private:
  /// Of a run that is still to be made.
  struct Place {
    std::size_t simulation;
    std::size_t index;
  };

  void load(std::size_t simulation, const ExperimentSize& size, std::uint32_t repeat, bool forget) {
    auto steps = load_run(folder_, simulations()[simulation], size, repeat, forget);
    // Simulations take differently long: each shard gets some of each.
    const auto turn = static_cast<std::uint32_t>(simulation + runs_[simulation].size());
    if (steps) ++kept_;
    if (!steps && shard_.has(turn)) missing_.push_back({simulation, runs_[simulation].size()});
    runs_[simulation].push_back({size.seed, repeat, steps ? std::move(*steps) : ExperimentRun{}});
  }

  void show(const Simulation& simulation, const TimedRun& run, std::uint32_t step) const {
    const double all = static_cast<double>(missing_.size()) * plan_.size.steps;
    const double done = static_cast<double>(done_) * plan_.size.steps + step - 1;
    const std::string left = stint_.left(done, all);
    line_.show("run " + std::to_string(done_ + 1) + " of " + std::to_string(missing_.size()) +
               ": simulation " + std::to_string(simulation.number) + " (" + std::string(simulation.scene) +
               "), seed " + std::to_string(run.seed) + ", repeat " + std::to_string(run.repeat) + "  step " +
               std::to_string(step) + "/" + std::to_string(plan_.size.steps) +
               (left.empty() ? "" : "  about ") + left);
  }

  [[nodiscard]] std::string interruption() const {
    const std::size_t all = runs_.size() * plan_.runs();
    return "interrupted: " + std::to_string(kept_ + done_) + " of " + std::to_string(all) + " runs are in " +
           folder_.string() + "; the same command goes on from there";
  }

  std::filesystem::path folder_;
  ExperimentPlan plan_;
  Shard shard_;
  Replace replace_;
  ExperimentRuns runs_;
  std::vector<Place> missing_;
  std::size_t kept_ = 0;  ///< runs that were there
  std::size_t done_ = 0;  ///< of the missing ones
  ProgressLine line_;
  Stint stint_;
};

/// Runs the related work on each simulation with each seed; writes the page.
void compare_related(const ExperimentPlan& plan, const std::filesystem::path& folder, Replace replace) {
  const InterruptGuard interrupt;
  make_writable_folder(folder);
  const ProgressLine line;
  PartFile page(folder / kRelatedName, replace);
  RelatedRuns runs;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    for (std::uint32_t seed = 0; seed < plan.seeds; ++seed) {
      const Simulation& simulation = simulations()[k];
      const ExperimentRun run = run_simulation(
          simulation, plan.with_seed(seed), {related_contestants(), true}, [&](std::uint32_t step) {
            line.show("simulation " + std::to_string(simulation.number) + " (" +
                      std::string(simulation.scene) + "), seed " + std::to_string(plan.with_seed(seed).seed) +
                      "  step " + std::to_string(step) + "/" + std::to_string(plan.size.steps));
            return !interrupt.requested();
          });
      if (interrupt.requested()) throw Interrupted("interrupted: nothing was written");
      runs[k].push_back(summarise(run));
    }
  }
  page.write(related_page(runs, plan.size));
  page.keep();
}

}  // namespace

ExperimentCommand::ExperimentCommand(CLI::App& program)
    : command_(
          program.add_subcommand("experiment", "Run the paper's experiment: figures 12, 13 and its claims")) {
  command_->add_option("--steps", steps_, "Of each simulation (default 1200; the paper: 6000)")
      ->type_name("N");
  command_->add_option("--objects", objects_, "Moving ones at the end (default 2000; the paper: 4250)")
      ->type_name("N");
  command_->add_option("--seeds", seeds_, "Each simulation is run with so many, from --seed on (default 3)")
      ->type_name("N");
  command_
      ->add_option("--repeats", repeats_,
                   "Each run is repeated so often, one repeat of all after the other (default 1)")
      ->type_name("N");
  command_->add_flag(
      "--full", full_,
      "The paper's size, and enough runs: --steps 6000 --objects 4250 --seeds 3 --repeats 5 (hours)");
  command_->add_flag(
      "--related", related_,
      "Instead: the related work of the paper's section 2 on the same simulations, and what the "
      "paper says of it");
  command_->add_option("--seed", seed_, "The first one of every random choice (default 1)")->type_name("S");
  add_output(*command_, "--out", out_, "Folder (default out/experiment)", "DIR");
  command_
      ->add_option("--shard", shard_,
                   "Only every N-th run, the K-th first, and no pages: on other machines, in one folder")
      ->type_name("K/N");
  command_->add_flag("--overwrite", overwrite_,
                     "Replace an earlier page and its figures, and runs of another size");
  command_->footer(
      "OUTPUT  DIR/experiment.html (with --related DIR/related.html), which opens offline, and "
      "DIR/experiment.md: figures 12 and 13, and of "
      "each\n"
      "        statement of the paper's sections 6.2 and 7 whether it holds here; DIR/figure-12 and "
      "figure-13, as "
      ".svg and .png;\n        DIR/simulation-N-SCENE-seed-S-repeat-R.csv, a line for each step and broad "
      "phase. "
      "Ctrl-C keeps the runs that are done,\n        and the same command goes on from there.");
}

bool ExperimentCommand::chosen() const { return command_->parsed(); }

void ExperimentCommand::run() const {
  if (full_ && !(steps_.empty() && objects_.empty() && seeds_.empty() && repeats_.empty()))
    throw UsageError(
        "--full says the steps, objects, seeds and repeats already; leave out --steps, --objects, --seeds "
        "and "
        "--repeats");
  if (related_ && !(repeats_.empty() && shard_.empty()))
    throw UsageError("--related makes all its runs at once: leave out --repeats and --shard");
  ExperimentPlan plan = full_ ? kFullPlan : ExperimentPlan{};
  if (!steps_.empty()) plan.size.steps = parse_whole<std::uint32_t>("--steps", steps_, 50, 1'000'000);
  if (!objects_.empty()) plan.size.objects = parse_whole<std::uint32_t>("--objects", objects_, 50, 100'000);
  if (!seeds_.empty()) plan.seeds = parse_whole<std::uint32_t>("--seeds", seeds_, 1, 1000);
  if (!repeats_.empty()) plan.repeats = parse_whole<std::uint32_t>("--repeats", repeats_, 1, 1000);
  if (!seed_.empty()) plan.size.seed = parse_whole<std::uint32_t>("--seed", seed_, 0, UINT32_MAX);
  const std::filesystem::path folder = out_.empty() ? "out/experiment" : out_;
  Outputs outputs({}, overwrite_);
  outputs.add_folder(folder);
  if (!shard_.empty()) {
    Experiment experiment(folder, plan, parse_shard(shard_), outputs.replace());
    experiment.run();
    std::printf("%s\n", experiment.shard_words(shard_).c_str());
    return;
  }
  require_gnuplot();
  if (related_) {
    outputs.add_file(folder / kRelatedName);
    compare_related(plan, folder, outputs.replace());
    std::printf("%s\n", (folder / kRelatedName).string().c_str());
    return;
  }
  for (const char* const figure : kFigureNames) outputs.add_file(folder / figure);
  outputs.add_file(folder / kTextName);
  outputs.add_file(folder / kPageName);
  Experiment experiment(folder, plan, Shard{}, outputs.replace());
  experiment.run();
  experiment.report();
  std::printf("%s\n", (folder / kPageName).string().c_str());
}

}  // namespace kerf
