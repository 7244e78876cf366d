#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/replay/replayer.h"

namespace kerf {

/// What a tree is asked in a step, and with which configuration it takes it.
template <int D>
struct ScenarioStep {
  StepRequests<D> requests;
  Config config;
  std::string name;                         ///< what the other engine calls it, see GivenNames
  std::optional<std::vector<Pair>> theirs;  ///< somebody else's pairs, if they are known
  TheirChanges<D> changes;                  ///< what else they are judged by
};

/// What a tree is asked, step by step, apart from any recording: something that can be made smaller and run
/// again. Decisions about single events are not part of it: with other objects or steps there are other
/// events.
template <int D>
struct Scenario {
  RecordingInfo info;
  std::vector<ScenarioStep<D>> steps;

  [[nodiscard]] std::size_t requests() const;
};

/// Operators of one kind that act in one step.
struct Acting {
  std::size_t step = 0;  ///< index in Scenario::steps
  Operator op = Operator::split;
  friend bool operator==(const Acting&, const Acting&) = default;
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

/// Runs the scenario and tells which operators act when.
template <int D>
std::vector<Acting> acting_operators(const Scenario<D>& scenario);
/// Without these: in their steps, their operators are switched off.
template <int D>
Scenario<D> without_operators(Scenario<D> scenario, const std::vector<Acting>& left_out);

/// Runs the scenario and records it. Throws as RecordingWriter does.
template <int D>
void record(const Scenario<D>& scenario, const std::filesystem::path& path);

}  // namespace kerf
