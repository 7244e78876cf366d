#include <cstdio>
#include <stdexcept>
#include <string>
#include <variant>

#include "frames/bench/ablation.h"
#include "frames/bench/bench_cell.h"
#include "frames/bench/bench_report.h"
#include "frames/bench/bench_request.h"
#include "frames/bench/loop_report.h"
#include "frames/bench/queries/query_report.h"
#include "frames/bench/random/random_bench.h"
#include "frames/catalog/algorithm.h"
#include "frames/commands/command.h"
#include "frames/support/errors.h"
#include "frames/support/interrupt.h"
#include "frames/support/outputs.h"
#include "frames/support/progress.h"
#include "frames/support/result_file.h"

namespace kerf {
namespace {

std::string bench_footer() {
  std::string text = "SCENES      ";
  for (const BenchScene& scene : bench_scenes())
    text += (&scene == bench_scenes().data() ? "" : ", ") + std::string(scene.name);
  text += "\nALGORITHMS\n";
  const auto line = [&text](const auto& algorithm) {
    std::string name = "  " + algorithm.name;
    name.resize(26, ' ');
    text += name + algorithm.what + (algorithm.by_default ? "" : " (only if named, or with 'all')") + "\n";
  };
  for (const auto& algorithm : algorithms<3>()) line(algorithm);
  for (const auto& algorithm : algorithms<2>())
    if (!find_algorithm<3>(algorithm.name)) line(algorithm);
  return text +
         "  kerf:K=V:K=V...         with other parameters (see `kerf render --help`); also "
         "kerf-paper:K=V...\n"
         "  kerf:period=4:margin=0.2  approximate on purpose: placed every so many steps, boxes widened; "
         "also\n"
         "                         filter=1, grid=SIZE and shrink=1 (see "
         "core/broad_phase/approximation.h)\n\n"
         "Each algorithm is given the same boxes, in a process of its own, a block of steps at a time in "
         "turn, and\nhas to report the complete set of pairs in each step, which is compared with the truth. "
         "Of each step the\nleast of all rounds counts. FLOORS are multiples of the time that it takes to "
         "read all boxes and write\nall pairs. Ctrl-C ends early and keeps what was measured.";
}

void print(const std::string& line) {
  if (std::puts(line.c_str()) < 0 || std::fflush(stdout) != 0)
    throw std::runtime_error("cannot write to standard output");
}

CellPlan plan_for(const BenchRequest& request, const BenchScene& scene, std::uint32_t objects,
                  unsigned threads) {
  CellPlan plan;
  plan.scene = scene.name;
  plan.objects = objects;
  plan.threads = threads;
  plan.algorithms = request.algorithms;
  plan.rounds = request.rounds;
  plan.warm_up = request.warm_up_for(objects);
  plan.steps = request.steps_for(objects);
  plan.seed = request.seed;
  plan.patience = request.patience;
  plan.trace = request.trace;
  return plan;
}

/// Growing scenes have all their objects when the warm-up ends.
LoopPlan plan_for(const BenchRequest& request, const CatalogScene& scene, std::uint32_t objects) {
  LoopPlan plan;
  plan.scene = scene;
  plan.broad_phases = request.algorithms;
  if (request.ablation) {
    plan.broad_phases.resize(1);
    plan.variants.assign(request.algorithms.begin() + 1, request.algorithms.end());
  }
  plan.rounds = request.rounds;
  plan.warm_up = request.warm_up_for(objects);
  plan.steps = request.steps_for(objects);
  plan.options.objects = objects;
  plan.options.seed = request.seed;
  const bool grows = std::visit([](const auto* entry) { return entry->grows; }, scene.entry);
  if (grows) plan.options.steps = plan.warm_up;
  return plan;
}

std::vector<CellPlan> plans_of(const BenchRequest& request) {
  std::vector<CellPlan> plans;
  for (const std::uint32_t objects : request.objects)
    for (const unsigned threads : request.threads)
      for (const BenchScene* scene : request.scenes)
        plans.push_back(plan_for(request, *scene, objects, threads));
  return plans;
}

class Bench {
 public:
  Bench(const BenchRequest& request, Replace replace) : request_(request), json_(request.json, replace) {}

  void run() {
    if (request_.queries) {
      measure_queries();
    } else if (request_.random > 0) {
      measure_scenes_at_random();
    } else if (request_.simulations.empty()) {
      measure_cells();
    } else {
      measure_simulations();
    }
    if (interrupt_.requested()) throw Interrupted("interrupted; " + json_.end_early());
    save(true);
    if (request_.random > 0) print(random_summary(request_, random_));
    if (request_.ablation) print(ablation_table(earnings(all_.cells.rows, std::string(kTunedTree))));
  }

 private:
  void measure_cells() {
    print(bench_heading());
    const std::vector<CellPlan> plans = plans_of(request_);
    const std::size_t cells = plans.size() * request_.dimensions.size();
    std::size_t cell = 0;
    const CellWatch watch{[&](const std::string& text) {
                            line_.show(std::to_string(cell) + "/" + std::to_string(cells) + "  " + text);
                          },
                          [this] { return interrupt_.requested(); }};
    for (const CellPlan& plan : plans)
      for (const int dimension : request_.dimensions) {
        if (interrupt_.requested()) break;
        ++cell;
        add(dimension == 2 ? measure_cell<2>(plan, watch) : measure_cell<3>(plan, watch));
      }
  }
  void measure_queries() {
    print(query_heading());
    const auto goes_on = [this] { return !interrupt_.requested(); };
    for (const std::uint32_t objects : request_.objects)
      for (const BenchScene* scene : request_.scenes)
        for (const int dimension : request_.dimensions) {
          if (!goes_on()) return;
          QueryPlan plan;
          plan.scene = scene;
          plan.objects = objects;
          plan.rounds = request_.rounds;
          plan.warm_up = request_.warm_up_for(objects);
          plan.seed = request_.seed;
          line_.show(std::string(scene->name));
          const std::vector<QueryRow> rows = dimension == 2 ? kerf::measure_queries<2>(plan, goes_on)
                                                            : kerf::measure_queries<3>(plan, goes_on);
          line_.clear();
          for (const QueryRow& row : rows) print(as_text(row));
          queries_.insert(queries_.end(), rows.begin(), rows.end());
          save(false);
        }
  }
  void measure_scenes_at_random() {
    print(random_heading());
    const CellWatch watch{[this](const std::string& text) { line_.show(text); },
                          [this] { return interrupt_.requested(); }};
    measure_random(request_, watch, [this](RandomOutcome outcome) {
      line_.clear();
      print(as_text(outcome));
      random_.push_back(std::move(outcome));
      save(false);
    });
  }
  void measure_simulations() {
    print(loop_heading());
    const CellWatch watch{[this](const std::string& text) { line_.show(text); },
                          [this] { return interrupt_.requested(); }};
    for (const CatalogScene& scene : request_.simulations)
      for (const std::uint32_t objects : request_.objects) {
        const std::vector<LoopRow> rows = measure_loops(plan_for(request_, scene, objects), watch);
        line_.clear();
        for (const LoopRow& row : rows) {
          print(as_text(row));
          if (request_.ablation)
            all_.cells.rows.insert(all_.cells.rows.end(), row.alone.begin(), row.alone.end());
        }
        all_.loops.insert(all_.loops.end(), rows.begin(), rows.end());
        save(false);
      }
  }
  void add(const CellResult& cell) {
    line_.clear();
    for (const BenchRow& row : cell.rows) print(as_text(row));
    for (const BenchGap& gap : cell.gaps) print(as_text(gap));
    all_.cells.rows.insert(all_.cells.rows.end(), cell.rows.begin(), cell.rows.end());
    all_.cells.gaps.insert(all_.cells.gaps.end(), cell.gaps.begin(), cell.gaps.end());
    save(false);
  }
  void save(bool complete) {
    json_.save(request_.queries      ? as_json(request_, queries_, complete)
               : request_.random > 0 ? as_json(request_, random_, complete)
                                     : as_json(request_, all_, complete),
               complete);
  }

  const BenchRequest& request_;
  InterruptGuard interrupt_;
  ResultFile json_;
  ProgressLine line_;
  BenchResult all_;
  std::vector<QueryRow> queries_;
  std::vector<RandomOutcome> random_;
};

class BenchCommand final : public Command {
 public:
  explicit BenchCommand(CLI::App& program);
  void run() const override;

 private:
  BenchTexts texts_;
  bool overwrite_ = false;
};

BenchCommand::BenchCommand(CLI::App& program)
    : Command(program, "bench", "Measure broad phases, ours and others', on the same boxes") {
  option("--scenes", texts_.scenes, "Which motions (see below; default all)", "A,B,...");
  option("--simulations", texts_.simulations,
         "Instead: broad phases in the loop of these scenes of `kerf render` (or all), beside the same boxes "
         "alone",
         "A,B,...");
  option("--random", texts_.random,
         "Instead: so many scenes drawn by --seed (docs/WHICH.md), the tuned tree beside columns, "
         "sort-and-sweep and the libraries",
         "N");
  option("--first", texts_.first, "Begin with the F-th random scene of the seed (default 1)", "F");
  option("--most", texts_.most, "Random scenes have so many boxes at most (default 256000)", "N");
  option("--objects", texts_.objects, "How many boxes (default 1000,4250,16000)", "N,N,...");
  option("--dims", texts_.dimensions, "2, 3 or both (default 2,3)", "D,D");
  option("--algorithms", texts_.algorithms, "Which broad phases, see below", "A,B,...");
  option("--threads", texts_.threads, "Threads of an algorithm; one that has fewer is left out (default 1)",
         "T,T,...");
  option("--rounds", texts_.rounds, "How often all is repeated (default 3; with --queries 15)", "R");
  option("--steps", texts_.steps, "Measured steps (default 12 to 300, by the number of boxes)", "N");
  option("--warm-up", texts_.warm_up, "Steps before them (default 8 to 48, by the number of boxes)", "N");
  option("--seed", texts_.seed, "Of the motions (default 1)", "S");
  option("--patience", texts_.patience,
         "Seconds of a round after which an algorithm is left out (default 30; with --random 5)", "S");
  output("--json", texts_.json, "Also all figures as JSON, after each cell");
  command_->add_flag("--overwrite", overwrite_, "Replace an earlier JSON file");
  command_->add_flag("--ablation", texts_.ablation,
                     "What each policy of the tuned tree earns: beside it, the tree without the policy, in "
                     "scenes or simulations");
  command_->add_flag("--queries", texts_.queries,
                     "Instead of pairs: queries on the boxes of scenes (default uniform, settled and needles "
                     "of 4250 and 64000 objects), ours and other libraries'");
  command_->add_flag("--trace", texts_.trace, "The JSON has the time of each step, too");
  command_->footer(bench_footer());
}

void BenchCommand::run() const {
  const BenchRequest request = parse_bench_request(texts_);
  Outputs outputs({}, overwrite_);
  outputs.add_file(request.json);
  Bench(request, outputs.replace()).run();
}

}  // namespace

AnyCommand make_bench_command(CLI::App& program) { return std::make_unique<BenchCommand>(program); }

}  // namespace kerf
