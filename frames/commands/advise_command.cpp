#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "frames/advise/advice_report.h"
#include "frames/advise/recorded_motion.h"
#include "frames/catalog/algorithm.h"
#include "frames/commands/command.h"
#include "frames/page/gnuplot.h"
#include "frames/sequence/recorded_steps.h"
#include "frames/sequence/recording_file.h"
#include "frames/support/errors.h"
#include "frames/support/interrupt.h"
#include "frames/support/outputs.h"
#include "frames/support/parse_number.h"
#include "frames/support/progress.h"
#include "frames/support/result_file.h"
#include "frames/support/suggest.h"

namespace kerf {
namespace {

constexpr std::uint32_t kRounds = 5;
constexpr std::uint32_t kPatience = 10;

/// What the user asked for, except the outputs.
struct Question {
  std::filesystem::path file;
  std::string steps;
  std::string broad_phases;
  std::uint32_t rounds = kRounds;
  std::uint32_t patience = kPatience;
};

template <int D>
std::vector<std::string> all_broad_phases() {
  std::vector<std::string> names;
  for (const Algorithm<D>& algorithm : algorithms<D>()) names.push_back(algorithm.name);
  return names;
}

template <int D>
std::vector<std::string> asked_broad_phases(const std::string& text) {
  if (text.empty()) return all_broad_phases<D>();
  std::vector<std::string> names;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    names.push_back(text.substr(begin, end - begin));
    begin = end + 1;
    if (!find_algorithm<D>(names.back()))
      throw UsageError("--broad-phases: " + unknown_name_message(std::to_string(D) + "D broad phase",
                                                                 names.back(), all_broad_phases<D>()));
    if (std::ranges::count(names, names.back()) > 1)
      throw UsageError("--broad-phases '" + text + "' names one twice");
  }
  return names;
}

/// The steps asked for; by default the last ones, of a large scene fewer.
template <int D>
StepRange asked_steps(const std::string& text, RecordingReader<D>& recording) {
  constexpr std::uint32_t kObjectSteps = 8'000'000;
  constexpr std::uint32_t kFewest = 30;
  const std::uint32_t steps = recording.steps();
  StepRange range{1, steps, 1};
  if (!text.empty()) {
    range = parse_recorded_steps(text, recording.info().names, steps);
    if (range.stride != 1) throw UsageError("--steps '" + text + "': every step is measured; give A:B");
  } else if (steps > 0) {
    const std::uint32_t objects = std::max(recording.row(steps).statistics.objects, 1U);
    const std::uint32_t most = std::max(kObjectSteps / objects, kFewest);
    if (steps > most) range.first = steps - most;
  }
  if (steps == 0 || range.first >= range.last)
    throw UsageError(
        "there is nothing to measure in one step: it takes two at least, the first of which inserts the "
        "objects");
  return range;
}

CellPlan plan_of(const Question& question, const StepRange& steps, std::vector<std::string> broad_phases) {
  constexpr std::uint32_t kMostWarmUp = 48;
  CellPlan plan;
  plan.scene = question.file.stem().string();
  plan.algorithms = std::move(broad_phases);
  plan.rounds = question.rounds;
  const std::uint32_t moves = steps.last - steps.first;
  plan.warm_up = std::min(moves / 10, kMostWarmUp);
  plan.steps = moves - plan.warm_up;
  plan.patience = question.patience;
  plan.tests = true;
  return plan;
}

template <int D>
AdvisedRecording measure_recording(const Question& question, std::shared_ptr<RecordingReader<D>> recording,
                                   const CellWatch& watch) {
  std::vector<std::string> names = asked_broad_phases<D>(question.broad_phases);
  AdvisedRecording advised;
  advised.steps = asked_steps(question.steps, *recording);
  advised.file = question.file.string();
  advised.dimension = D;
  advised.rounds = question.rounds;
  advised.steps_text = recording->info().names.steps(advised.steps.first, advised.steps.last);
  advised.plan = plan_of(question, advised.steps, std::move(names));
  const RecordedRun<D> run(recording, advised.steps, [&](std::uint32_t step) {
    watch.progress("reading step " + std::to_string(step));
    if (watch.stop()) throw Interrupted("interrupted; nothing was measured");
  });
  if (run.objects() == 0) throw UsageError(advised.file + " has no objects in these steps");
  advised.plan.objects = run.objects();
  const MotionSource<D> source = [&run] { return run.motion(); };
  advised.cell = measure_cell<D>(advised.plan, source, watch);
  // Each object that comes has a number of its own in the motion, and memory and time are those of all that
  // are there.
  for (BenchRow& row : advised.cell.rows) share_among(row, run.most_at_once());
  for (BenchGap& gap : advised.cell.gaps) gap.cell.objects = run.most_at_once();
  return advised;
}

void write_file(const std::string& path, Replace replace, const std::string& text) {
  if (path.empty()) return;
  PartStream file(path, replace);
  file.stream() << text;
  file.keep();
}

class AdviseCommand final : public Command {
 public:
  explicit AdviseCommand(CLI::App& program);
  void run() const override;

 private:
  std::string file_;
  std::string steps_;
  std::string broad_phases_;
  std::string rounds_;
  std::string patience_;
  std::string json_;
  std::string plot_;
  bool overwrite_ = false;
};

AdviseCommand::AdviseCommand(CLI::App& program)
    : Command(program, "advise",
              "Say which broad phase is the fastest on a recording, by running them all on its boxes") {
  option("FILE", file_, "A recording, for example by `kerf import`", "")->required();
  option("--steps", steps_, "Which (default all; the last 8,000,000 / objects of a long recording)", "A:B");
  option("--broad-phases", broad_phases_,
         "Only these, see `kerf bench --help`; kerf:K=V has other parameters (default all that there are)",
         "A,B,...");
  option("--rounds", rounds_, "How often all is repeated, 2 or more (default 5)", "R");
  option("--patience", patience_, "Seconds of a round after which a broad phase is left out (default 10)",
         "S");
  output("--json", json_, "Also all figures as JSON");
  output("--plot", plot_, "Also a picture of the times, an .svg");
  command_->add_flag("--overwrite", overwrite_, "Replace earlier files");
  command_->footer(
      "TIMES   the time of a step over that of the fastest, the median of the rounds, and ROUNDS the least "
      "and\n"
      "        the most of them: from below 1 on it is noise\n"
      "P99     what 99 % of the steps do not exceed, over the median; WORST: the longest step over the "
      "median\n"
      "TESTS   pairs of boxes compared in the last step for each pair found; -: the structure does not "
      "count\n"
      "\n"
      "Each broad phase gets the same boxes in a process of its own, a block of steps at a time in turn, and "
      "has to\nreport the complete pairs of each step. One that does not is named and never advised.");
}

void AdviseCommand::run() const {
  Question question{file_, steps_, broad_phases_, kRounds, kPatience};
  if (!rounds_.empty()) question.rounds = parse_whole<std::uint32_t>("--rounds", rounds_, 2, 1000);
  if (!patience_.empty()) question.patience = parse_whole<std::uint32_t>("--patience", patience_, 1, 3600);
  if (!plot_.empty() && !plot_.ends_with(".svg"))
    throw UsageError("--plot '" + plot_ + "': call the picture something.svg");
  Outputs outputs({file_}, overwrite_);
  outputs.add_file(json_);
  outputs.add_file(plot_);
  if (!plot_.empty()) require_gnuplot();
  const InterruptGuard interrupt;
  const ProgressLine line;
  const CellWatch watch{[&](const std::string& text) { line.show(text); },
                        [&] { return interrupt.requested(); }};
  AdvisedRecording advised = with_recording(
      file_, [&](auto recording) { return measure_recording(question, std::move(recording), watch); });
  line.clear();
  if (interrupt.requested()) throw Interrupted("interrupted; nothing is advised or written");
  advised.advice = advise(advised.cell);
  std::fputs(advice_text(advised).c_str(), stdout);
  write_file(json_, outputs.replace(), advice_json(advised));
  if (!plot_.empty()) write_file(plot_, outputs.replace(), advice_plot(advised));
}

}  // namespace

AnyCommand make_advise_command(CLI::App& program) { return std::make_unique<AdviseCommand>(program); }

}  // namespace kerf
