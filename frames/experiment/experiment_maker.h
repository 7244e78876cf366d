#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "frames/experiment/experiment_file.h"
#include "frames/support/atomic_file.h"
#include "frames/support/progress.h"
#include "frames/support/shard.h"

namespace kerf {

/// Makes the runs of an experiment's shard of which there is no file yet, and reads them all.
class ExperimentMaker {
 public:
  /// Throws as `load_run` does if a file that is there is none of this experiment, and std::runtime_error if
  /// nothing can be written to the folder. With `Replace::earlier` files of another size count as none.
  ExperimentMaker(std::filesystem::path folder, const ExperimentPlan& plan, const Shard& shard,
                  Replace replace);

  /// Each run is made in a process of its own: in one for all, memory of earlier runs lay among that of later
  /// ones, and steps that ask for memory took up to twenty times as long. Throws Interrupted, which says what
  /// is kept, when `stop` becomes true, and std::runtime_error for a run that fails.
  void make(const std::function<bool()>& stop);

  /// How many runs `make` is to make.
  [[nodiscard]] std::size_t missing() const { return missing_.size(); }
  /// How many it has made.
  [[nodiscard]] std::size_t made() const { return made_; }

  /// Reads all runs, one after the other. Pre: they are there.
  void for_each(const std::function<void(const RunId&, ExperimentRun)>& visit) const;

 private:
  void make_one(const RunId& run, const std::function<bool()>& stop);
  void show(const RunId& run, std::uint32_t step) const;
  [[nodiscard]] std::string interruption() const;

  std::filesystem::path folder_;
  std::uint32_t steps_;  ///< of a run
  bool forgets_;
  std::vector<RunId> runs_;  ///< a repeat of all seeds after the other
  std::vector<RunId> missing_;
  std::size_t kept_ = 0;  ///< runs that were there
  std::size_t made_ = 0;  ///< of the missing ones
  ProgressLine line_;
  Stint stint_;
};

}  // namespace kerf
