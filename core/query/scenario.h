#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/replay/replayer.h"

namespace kerf {

/// The requests of a step, and its configuration.
template <int D>
struct ScenarioStep {
  StepRequests<D> requests;
  std::vector<LookChange<D>> looks;  ///< what changes in how objects look; of an object the last one counts
  Config config;
  std::string name;                         ///< what the other engine calls it, see GivenNames
  std::optional<std::vector<Pair>> theirs;  ///< another engine's pairs, if they are known
  TheirChanges<D> changes;                  ///< what else they are judged by
};

/// The requests to a tree, step by step, independent of a recording: they can be reduced and run again.
/// Decisions about single events are not part of it: with other objects or steps there are other events.
template <int D>
struct Scenario {
  RecordingInfo info;
  std::vector<ScenarioStep<D>> steps;
  std::shared_ptr<const std::vector<Shape<D>>> shapes;  ///< those of the looks; null: none are known

  [[nodiscard]] std::size_t requests() const;
};

/// Operators of one kind that act in one step.
struct Acting {
  std::size_t step = 0;  ///< index in Scenario::steps
  Operator op = Operator::split;
  friend bool operator==(const Acting&, const Acting&) = default;
};

/// The steps of a recording up to `last`. Those up to `first` become one, in which every object gets its
/// place at their end; with 0 or 1 all steps stay as they are.
template <int D>
Scenario<D> scenario_of(Replayer<D>& replayer, std::uint32_t first, std::uint32_t last);

/// Every object in any request or pair of another engine, which may have no box, in the order of their ids.
template <int D>
std::vector<ObjectId> objects_of(const Scenario<D>& scenario);
/// Only the requests for these objects, given in the order of their ids.
template <int D>
Scenario<D> with_objects(const Scenario<D>& scenario, const std::vector<ObjectId>& kept);
/// Only these steps, given in their order; requests of the others move to the next step that is kept.
template <int D>
Scenario<D> with_steps(const Scenario<D>& scenario, const std::vector<std::size_t>& kept);

/// Runs the scenario and returns which operators act when.
template <int D>
std::vector<Acting> acting_operators(const Scenario<D>& scenario);
/// Switches these operators off in their steps.
template <int D>
Scenario<D> without_operators(Scenario<D> scenario, const std::vector<Acting>& left_out);

/// Runs the scenario and records it. Throws as RecordingWriter does.
template <int D>
void record(const Scenario<D>& scenario, const std::filesystem::path& path);

}  // namespace kerf
