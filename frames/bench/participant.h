#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "frames/bench/bench_cell.h"
#include "frames/bench/subject.h"
#include "frames/support/child_process.h"

namespace kerf {

/// An algorithm in a cell: its process in the present round, and its measurements so far.
class Participant {
 public:
  Participant(std::string name, std::uint32_t block, const CellPlan& plan);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const Answers& answers() const { return answers_; }

  /// A new round in a new process; an algorithm that failed before does not take part.
  void start(const Life& life);
  /// Inserts the objects of the block's first step. It may take ten times the patience: some libraries are
  /// slow to begin and fast then, and the time to begin is no part of a step's.
  void build(const CellWatch& watch);
  /// Does `count` steps. `first` is the number of the first one among those that count; a negative number is
  /// a warm-up step.
  void run(std::int64_t first, std::uint32_t count, const CellWatch& watch);
  /// Ends the round.
  void finish(const CellWatch& watch);

  /// None if no step was measured.
  [[nodiscard]] std::optional<BenchRow> row(const CellName& cell, bool trace) const;
  [[nodiscard]] const std::string& trouble() const { return trouble_; }

 private:
  static constexpr std::uint64_t kNever = UINT64_MAX;
  /// `limit` in seconds.
  bool ask(Request request, double limit, const CellWatch& watch);
  void count_tests(const CellWatch& watch);
  void keep(std::int64_t step, const StepResult& result);

  const CellPlan& plan_;
  std::string name_;
  Answers answers_;
  std::unique_ptr<ChildProcess> process_;
  std::vector<std::uint64_t> nanoseconds_;  ///< per step the least of all rounds
  std::vector<std::uint64_t> added_;        ///< likewise, of added work
  std::vector<std::uint64_t> missed_;       ///< per step the most of all rounds
  std::vector<std::uint64_t> extra_;        ///< likewise
  std::vector<std::uint64_t> round_;        ///< per step, of the present round
  std::vector<double> round_medians_;
  std::uint64_t build_ = kNever;
  std::uint64_t pairs_ = 0;
  std::uint64_t steps_ = 0;  ///< in all rounds
  std::uint64_t bytes_ = 0;
  std::optional<double> tests_per_pair_;
  double spent_ = 0;  ///< seconds of steps in this round
  std::string trouble_;
};

}  // namespace kerf
