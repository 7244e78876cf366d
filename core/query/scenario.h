#pragma once

#include <filesystem>
#include <vector>

#include "core/replay/replayer.h"

namespace kerf {

/// What a tree is asked, step by step, apart from any recording: something that can be made smaller and run
/// again.
template <int D>
struct Scenario {
  RecordingInfo info;
  std::vector<StepRequests<D>> steps;
  std::vector<std::vector<Pair>> theirs;  ///< somebody else's pairs of each step; empty unless they are known

  [[nodiscard]] std::size_t requests() const;
};

/// The steps of a recording up to `last`. Those up to `first` become one, in which every object is put where
/// it was at their end; with 0 or 1 all are as they were.
template <int D>
Scenario<D> scenario_of(Replayer<D>& replayer, std::uint32_t first, std::uint32_t last);

/// Every object that is ever asked for, in the order of their ids.
template <int D>
std::vector<ObjectId> objects_of(const Scenario<D>& scenario);
/// Only what concerns these objects, given in the order of their ids.
template <int D>
Scenario<D> with_objects(const Scenario<D>& scenario, const std::vector<ObjectId>& kept);
/// Only these steps, given in their order; what is asked in the others is asked in the next that is kept.
template <int D>
Scenario<D> with_steps(const Scenario<D>& scenario, const std::vector<std::size_t>& kept);

/// Runs the scenario and records it. Throws as RecordingWriter does.
template <int D>
void record(const Scenario<D>& scenario, const std::filesystem::path& path);

}  // namespace kerf
