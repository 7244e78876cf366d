#include "frames/commands/experiment_command.h"

#include <CLI/CLI.hpp>
#include <array>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "core/base/counted.h"
#include "frames/commands/output_option.h"
#include "frames/experiment/experiment_file.h"
#include "frames/experiment/experiment_page.h"
#include "frames/experiment/experiment_plots.h"
#include "frames/page/gnuplot.h"
#include "frames/support/atomic_file.h"
#include "frames/support/errors.h"
#include "frames/support/interrupt.h"
#include "frames/support/outputs.h"
#include "frames/support/parse_whole.h"
#include "frames/support/progress_line.h"

namespace kerf {
namespace {

constexpr const char* kPageName = "experiment.md";
constexpr ExperimentSize kFullSize{.steps = 6000, .objects = 4250};

/// Runs the simulations of which there is no file yet.
class Experiment {
 public:
  Experiment(std::filesystem::path folder, const ExperimentSize& size, Replace replace)
      : folder_(std::move(folder)), size_(size), replace_(replace) {
    const bool forget = replace == Replace::earlier;
    for (std::size_t k = 0; k < runs_.size(); ++k)
      if (auto run = load_run(folder_, simulations()[k], size_, forget)) runs_[k] = std::move(*run);
    for (const ExperimentRun& run : runs_) to_do_ += run.empty() ? size_.steps : 0;
    make_writable_folder(folder_);
  }

  void run() {
    const InterruptGuard interrupt;
    for (std::size_t k = 0; k < runs_.size(); ++k) {
      if (!runs_[k].empty()) continue;
      const Simulation& simulation = simulations()[k];
      runs_[k] = run_simulation(simulation, size_, [&](std::uint32_t step) {
        show(simulation, step);
        return !interrupt.requested();
      });
      if (interrupt.requested()) throw Interrupted(interruption(k));
      done_ += size_.steps;
      save_run(folder_, simulation, size_, runs_[k]);
    }
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
    PartFile page(folder_ / kPageName, replace_);
    page.write(experiment_page(size_, runs_));
    try {
      plot_experiment(files, runs_);
    } catch (const std::runtime_error&) {
      if (!interrupt.requested()) throw;  // an interrupt stops gnuplot, too
    }
    if (interrupt.requested())
      throw Interrupted("interrupted: the simulations are in " + folder_.string() +
                        "; the same command draws the figures");
    for (const auto& figure : figures) figure->keep();
    page.keep();
  }

 private:
  using Clock = std::chrono::steady_clock;

  void show(const Simulation& simulation, std::uint32_t step) const {
    const double done = done_ + step - 1;
    const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    const int left = done > 0 ? static_cast<int>(seconds * (to_do_ - done) / done) : 0;
    char text[160];
    std::snprintf(text, sizeof text, "simulation %d of 4 (%s)  step %u/%u  about %d:%02d left",
                  simulation.number, std::string(simulation.scene).c_str(), step, size_.steps, left / 60,
                  left % 60);
    line_.show(text);
  }

  [[nodiscard]] std::string interruption(std::size_t running) const {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < runs_.size(); ++k) kept += k != running && !runs_[k].empty() ? 1U : 0U;
    return "interrupted: " + counted_of(kept, 4, "simulation") + " in " + folder_.string() +
           "; the same command goes on from there";
  }

  std::filesystem::path folder_;
  ExperimentSize size_;
  Replace replace_;
  ExperimentRuns runs_;
  ProgressLine line_;
  Clock::time_point start_ = Clock::now();
  double to_do_ = 0;  ///< steps
  double done_ = 0;
};

}  // namespace

ExperimentCommand::ExperimentCommand(CLI::App& program)
    : command_(
          program.add_subcommand("experiment", "Run the paper's experiment: figures 12, 13 and its claims")) {
  command_->add_option("--steps", steps_, "Of each simulation (default 1200; the paper: 6000)")
      ->type_name("N");
  command_->add_option("--objects", objects_, "Moving ones at the end (default 2000; the paper: 4250)")
      ->type_name("N");
  command_->add_flag("--full", full_, "The paper's size: --steps 6000 --objects 4250 (about twenty minutes)");
  command_->add_option("--seed", seed_, "Of every random choice (default 1)")->type_name("S");
  add_output(*command_, "--out", out_, "Folder (default out/experiment)", "DIR");
  command_->add_flag("--overwrite", overwrite_,
                     "Replace an earlier page and its figures, and simulations of another size");
  command_->footer(
      "OUTPUT  DIR/experiment.md, which says of each claim of the paper's section 6.2 whether it holds "
      "here;\n"
      "        DIR/figure-12 and figure-13, as .svg and .png; DIR/simulation-N-SCENE.csv, a line for each "
      "step "
      "and\n        broad phase. Ctrl-C keeps the simulations that are done, and the same command goes on "
      "from "
      "there.");
}

bool ExperimentCommand::chosen() const { return command_->parsed(); }

void ExperimentCommand::run() const {
  if (full_ && !(steps_.empty() && objects_.empty()))
    throw UsageError("--full says the steps and objects already; leave out --steps and --objects");
  ExperimentSize size = full_ ? kFullSize : ExperimentSize{};
  if (!steps_.empty()) size.steps = parse_whole<std::uint32_t>("--steps", steps_, 50, 1'000'000);
  if (!objects_.empty()) size.objects = parse_whole<std::uint32_t>("--objects", objects_, 50, 100'000);
  if (!seed_.empty()) size.seed = parse_whole<std::uint32_t>("--seed", seed_, 0, UINT32_MAX);
  require_gnuplot();
  const std::filesystem::path folder = out_.empty() ? "out/experiment" : out_;
  Outputs outputs({}, overwrite_);
  outputs.add_folder(folder);
  for (const char* const figure : kFigureNames) outputs.add_file(folder / figure);
  outputs.add_file(folder / kPageName);
  Experiment experiment(folder, size, outputs.replace());
  experiment.run();
  experiment.report();
  std::printf("%s\n", (folder / kPageName).string().c_str());
}

}  // namespace kerf
