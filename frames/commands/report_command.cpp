#include <algorithm>
#include <cstdio>

#include "core/base/counted.h"
#include "frames/commands/command.h"
#include "frames/page/gnuplot.h"
#include "frames/report/report_request.h"
#include "frames/report/section.h"
#include "frames/support/atomic_file.h"
#include "frames/support/errors.h"
#include "frames/support/interrupt.h"
#include "frames/support/machine.h"
#include "frames/support/outputs.h"
#include "frames/support/progress.h"
#include "frames/support/version.h"

namespace kerf {
namespace {

std::vector<std::string> section_names() {
  std::vector<std::string> names;
  for (const Section& section : report_sections()) names.push_back(section.name);
  return names;
}

std::string report_footer() {
  std::string text = "SECTIONS\n";
  for (const Section& section : report_sections()) {
    std::string name = "  " + section.name;
    name.resize(14, ' ');
    text += name + section.title + "\n";
  }
  return text +
         "\nThe figures are kept beside the page, in a JSON file of its name. Ctrl-C keeps what was "
         "measured, and\nthe same command goes on from there. The page loads nothing from anywhere; its "
         "plots are gnuplot's.";
}

/// Measures and shows the chosen sections.
class Report {
 public:
  Report(const ReportRequest& request, Replace replace)
      : request_(request),
        replace_(replace),
        store_(request.kept, request.shard, request.fresh || request.overwrite) {
    if (request.fresh) store_.clear();
    for (const Section& section : report_sections())
      if (std::ranges::find(request.sections, section.name) != request.sections.end())
        sections_.push_back(&section);
  }

  void run() {
    const bool is_shard = request_.shard.count > 1;
    if (!is_shard) require_gnuplot();
    make_writable_folder(std::filesystem::absolute(request_.out).parent_path());
    const std::size_t made = measure();
    if (is_shard) {
      std::printf(
          "%s made, kept in %s; when all shards are there, the same command without --shard writes the "
          "page\n",
          counted(made, "measurement").c_str(), store_.file().c_str());
      return;
    }
    store_.join();
    write_file_atomically(request_.out, page().html(), replace_);
    std::printf("%s\n", std::filesystem::absolute(request_.out).c_str());
  }

 private:
  /// The cells of the shard that are not measured yet, each once.
  [[nodiscard]] std::vector<Cell> missing() const {
    std::vector<Cell> cells;
    for (const Section* section : sections_)
      for (Cell& cell : section->cells(request_)) {
        const auto same = [&](const Cell& other) { return other.key == cell.key; };
        if (std::ranges::none_of(cells, same)) cells.push_back(std::move(cell));
      }
    std::vector<Cell> missing;
    for (std::size_t k = 0; k < cells.size(); ++k)
      if (request_.shard.has(k) && !store_.has(cells[k].key)) missing.push_back(std::move(cells[k]));
    return missing;
  }
  /// How many were missing.
  std::size_t measure() {
    const std::vector<Cell> cells = missing();
    double work = 0;
    for (const Cell& cell : cells) work += cell.work;
    Countdown countdown(cells.size(), work);
    const InterruptGuard interrupt;
    std::size_t done = 0;
    const Poll poll = [&] {
      if (interrupt.requested())
        throw Interrupted("interrupted; " + counted_of(done, cells.size(), "measurement") + " kept in " +
                          store_.file().string() + ", and the same command goes on from there");
    };
    for (const Cell& cell : cells) {
      countdown.begin(cell.key, cell.work);
      store_.put(cell.key, cell.measure(poll));
      ++done;
    }
    return done;
  }
  [[nodiscard]] Page page() const {
    const Json machine = describe_machine();
    Page page("Kerf: speed against error",
              "Measured on " + machine.value("processor", "an unknown processor") + ", " +
                  std::to_string(machine.value("cores", 0)) + " cores, " + machine.value("vectors", "") +
                  ", " + machine.value("system", "") + ", " + machine.value("compiler", "") + ", kerf " +
                  version());
    page.paragraph(
        "What a broad phase that is wrong on purpose gains, and what that does to pairs, contacts and "
        "motion. Exact is the default; every approximate mode is an explicit setting, written as kerf bench "
        "takes it: period (placed every so many steps), margin (boxes widened by so much), filter (kept "
        "pairs are held against the latest boxes), grid (ends of boxes rounded to cells of that size), "
        "shrink (rounded inward).");
    page.paragraph(
        "The time of a step is the least of all rounds, since other work on the machine only ever adds; "
        "error bars reach to the mean of the slowest round. Where runs have seeds, figures are medians, and "
        "bars and bands their quartiles. The pointer shows the values of a point.");
    for (const Section* section : sections_) {
      page.section(section->name, section->title);
      section->write(request_, store_, page);
    }
    return page;
  }

  const ReportRequest& request_;
  Replace replace_;
  CellStore store_;
  std::vector<const Section*> sections_;
};

class ReportCommand final : public Command {
 public:
  explicit ReportCommand(CLI::App& program);
  void run() const override;

 private:
  ReportTexts texts_;
};

ReportCommand::ReportCommand(CLI::App& program)
    : Command(program, "report", "One page of speed against error, with plots and tables") {
  command_->add_option("sections", texts_.sections, "Which sections, see below (default all)");
  output("--out", texts_.out, "The page", "FILE.html")->capture_default_str();
  command_->add_flag("--full", texts_.full,
                     "The paper's 4,250 objects; 1,000 where pairs decide what moves (hours)");
  const auto count = [this](const char* name, std::string& text, const char* meaning) {
    option(name, text, meaning, "N");
  };
  count("--objects", texts_.objects,
        "Objects of every motion and scene (default 120 to 2000, by the section)");
  count("--steps", texts_.steps, "Steps of every motion and scene (default 100 and 250)");
  count("--rounds", texts_.rounds, "How often timed runs are repeated (default 3)");
  count("--seeds", texts_.seeds, "Seeds of scenes in which pairs decide what moves (default 16)");
  option("--shard", texts_.shard,
         "Only every N-th measurement, the K-th first, and no page: on like machines, in one folder", "K/N");
  option("--hardcases", texts_.hardcases, "Where ./run hardcases wrote its table", "FOLDER")
      ->capture_default_str();
  command_->add_flag("--fresh", texts_.fresh, "Measure anew what an earlier run has kept");
  command_->add_flag("--overwrite", texts_.overwrite, "Replace an earlier page");
  command_->footer(report_footer());
}

void ReportCommand::run() const {
  const ReportRequest request = parse_report_request(texts_, section_names());
  Outputs outputs({request.hardcases}, request.overwrite);
  if (request.shard.count == 1) outputs.add_file(request.out);
  Report(request, outputs.replace()).run();
  const std::filesystem::path table = request.hardcases / "hardcases.json";
  if (std::ranges::count(texts_.sections, "hardcases") > 0 && !std::filesystem::exists(table))
    std::fprintf(stderr,
                 "kerf: %s is not there, so the page has no table of hard cases; ./run hardcases makes it\n",
                 table.c_str());
}

}  // namespace

AnyCommand make_report_command(CLI::App& program) { return std::make_unique<ReportCommand>(program); }

}  // namespace kerf
