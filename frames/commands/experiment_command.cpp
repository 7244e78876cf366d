#include <array>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/base/counted.h"
#include "frames/commands/command.h"
#include "frames/experiment/experiment_maker.h"
#include "frames/experiment/experiment_page.h"
#include "frames/experiment/experiment_panels.h"
#include "frames/experiment/experiment_plan.h"
#include "frames/experiment/related.h"
#include "frames/page/gnuplot.h"
#include "frames/support/atomic_file.h"
#include "frames/support/errors.h"
#include "frames/support/interrupt.h"
#include "frames/support/outputs.h"
#include "frames/support/parse_number.h"
#include "frames/support/shard.h"

namespace kerf {
namespace {

constexpr const char* kTextName = "experiment.md";
constexpr const char* kPageName = "experiment.html";
constexpr const char* kRelatedName = "related.html";
constexpr ExperimentPlan kFullPlan{.size = {.steps = 6000, .objects = 4250}, .seeds = 3, .repeats = 5};

/// Draws the figures and writes the pages. All files are there before one of them gets its name.
void report_runs(const ExperimentPlan& plan, const ExperimentMaker& maker,
                 const std::filesystem::path& folder, Replace replace) {
  ExperimentRuns runs;
  maker.for_each([&](const RunId& run, ExperimentRun steps) {
    runs[run.simulation].push_back({run.size.seed, run.repeat, std::move(steps)});
  });
  const InterruptGuard interrupt;
  std::array<std::unique_ptr<PartFile>, kFigureNames.size()> figures;
  std::array<std::filesystem::path, kFigureNames.size()> files;
  for (std::size_t k = 0; k < figures.size(); ++k) {
    figures[k] = std::make_unique<PartFile>(folder / kFigureNames[k], replace);
    files[k] = figures[k]->path();
  }
  PartFile text(folder / kTextName, replace);
  PartFile page(folder / kPageName, replace);
  text.write(experiment_text(plan, runs));
  try {
    plot_experiment(files, runs);
    page.write(experiment_page(plan, runs));
  } catch (const std::runtime_error&) {
    if (!interrupt.requested()) throw;  // an interrupt stops gnuplot, too
  }
  if (interrupt.requested())
    throw Interrupted("interrupted: the simulations are in " + folder.string() +
                      "; the same command draws the figures");
  for (const auto& figure : figures) figure->keep();
  text.keep();
  page.keep();
}

/// The same for the related work.
void report_related(const ExperimentPlan& plan, const ExperimentMaker& maker,
                    const std::filesystem::path& folder, Replace replace) {
  RelatedRuns runs;
  maker.for_each([&](const RunId& run, const ExperimentRun& steps) {
    runs[run.simulation].push_back(summarise(steps));
  });
  write_file_atomically(folder / kRelatedName, related_page(plan, runs), replace);
}

void make_runs(ExperimentMaker& maker) {
  const InterruptGuard interrupt;
  maker.make([&] { return interrupt.requested(); });
}

class ExperimentCommand final : public Command {
 public:
  explicit ExperimentCommand(CLI::App& program);
  void run() const override;

 private:
  std::string steps_;
  std::string seeds_;
  std::string repeats_;
  std::string objects_;
  std::string seed_;
  std::string out_;
  std::string shard_;
  bool full_ = false;
  bool related_ = false;
  bool overwrite_ = false;
};

ExperimentCommand::ExperimentCommand(CLI::App& program)
    : Command(program, "experiment", "Run the paper's experiment: figures 12, 13 and its claims") {
  option("--steps", steps_, "Of each simulation (default 1200; the paper: 6000)", "N");
  option("--objects", objects_, "Moving ones at the end (default 2000; the paper: 4250)", "N");
  option("--seeds", seeds_, "Each simulation is run with so many, from --seed on (default 3)", "N");
  option("--repeats", repeats_,
         "Each run is repeated so often, one repeat of all after the other (default 1)", "N");
  command_->add_flag(
      "--full", full_,
      "The paper's size, and enough runs: --steps 6000 --objects 4250 --seeds 3 --repeats 5 (hours)");
  command_->add_flag("--related", related_,
                     "Instead: the related work of the paper's section 2 on the same simulations, and what "
                     "the paper says of it");
  option("--seed", seed_, "The first one of every random choice (default 1)", "S");
  output("--out", out_, "Folder (default out/experiment)", "DIR");
  option("--shard", shard_,
         "Only every N-th run, the K-th first, and no pages: on other machines with the same build of kerf, "
         "in one folder",
         "K/N");
  command_->add_flag(
      "--overwrite", overwrite_,
      "Replace an earlier page and its figures, and runs of another size or another build of kerf");
  command_->footer(
      "OUTPUT  DIR/experiment.html (with --related DIR/related.html), which opens offline, and\n"
      "        DIR/experiment.md: figures 12 and 13, and whether each statement of the paper's sections 6.2\n"
      "        and 7 holds here\n"
      "        DIR/figure-12 and figure-13, as .svg and .png\n"
      "        DIR/simulation-N-SCENE-seed-S-repeat-R.csv (related-simulation-...), a line for each step\n"
      "        and broad phase\n"
      "Ctrl-C keeps the runs that are done, and the same command goes on from there.");
}

void ExperimentCommand::run() const {
  if (full_ && !(steps_.empty() && objects_.empty() && seeds_.empty() && repeats_.empty()))
    throw UsageError(
        "--full says the steps, objects, seeds and repeats already; leave out --steps, --objects, --seeds "
        "and --repeats");
  ExperimentPlan plan = full_ ? kFullPlan : ExperimentPlan{};
  if (related_) plan.kind = RunKind::related;
  if (!steps_.empty()) plan.size.steps = parse_whole<std::uint32_t>("--steps", steps_, 50, 1'000'000);
  if (!objects_.empty()) plan.size.objects = parse_whole<std::uint32_t>("--objects", objects_, 50, 100'000);
  if (!seeds_.empty()) plan.seeds = parse_whole<std::uint32_t>("--seeds", seeds_, 1, 1000);
  if (!repeats_.empty()) plan.repeats = parse_whole<std::uint32_t>("--repeats", repeats_, 1, 1000);
  if (!seed_.empty()) plan.size.seed = parse_whole<std::uint32_t>("--seed", seed_, 0, UINT32_MAX);
  const std::filesystem::path folder = out_.empty() ? "out/experiment" : out_;
  Outputs outputs({}, overwrite_);
  outputs.add_folder(folder);
  if (!shard_.empty()) {
    ExperimentMaker maker(folder, plan, parse_shard(shard_), outputs.replace());
    make_runs(maker);
    std::printf(
        "%s of shard %s made in %s; when all shards are there, the same command without --shard writes the "
        "pages\n",
        counted(maker.made(), "run").c_str(), shard_.c_str(), folder.string().c_str());
    return;
  }
  require_gnuplot();
  const char* const page = related_ ? kRelatedName : kPageName;
  outputs.add_file(folder / page);
  if (!related_) {
    for (const char* const figure : kFigureNames) outputs.add_file(folder / figure);
    outputs.add_file(folder / kTextName);
  }
  ExperimentMaker maker(folder, plan, Shard{}, outputs.replace());
  make_runs(maker);
  (related_ ? report_related : report_runs)(plan, maker, folder, outputs.replace());
  std::printf("%s\n", (folder / page).string().c_str());
}

}  // namespace

AnyCommand make_experiment_command(CLI::App& program) { return std::make_unique<ExperimentCommand>(program); }

}  // namespace kerf
