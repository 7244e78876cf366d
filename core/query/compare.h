#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/recording/recording_reader.h"

namespace kerf {

/// A recording in figures over all its steps.
struct RecordingSummary {
  std::uint32_t steps = 0;
  bool complete = false;  ///< ended in order; if not, its run may have gone on
  std::array<std::uint64_t, kOperatorCount> operators{};
  std::uint64_t refused = 0;
  std::uint64_t pairs = 0;
  std::uint32_t height = 0;  ///< greatest
  double redundancy = 0;     ///< mean of the steps
  double milliseconds = 0;   ///< median of a step
  double most_milliseconds = 0;
};

/// The first event that the other run does not have; none: nothing more in that step.
struct EventDifference {
  std::uint32_t step = 0;
  std::optional<Event> a;
  std::optional<Event> b;
  friend bool operator==(const EventDifference&, const EventDifference&) = default;
};

/// The first step of both in which the pairs that two imports' engines reported differ.
struct TheirDifference {
  std::uint32_t step = 0;
  std::vector<std::string>
      only_a;  ///< "1,2", by their names; once for each time that the other reported it less often
  std::vector<std::string> only_b;
};

/// Where two recordings first differ, objects and steps being those that are called the same; steps are A's
/// numbers. Steps that only one of them has are not compared; `steps` has how many each has.
struct RecordingComparison {
  RecordingSummary a;
  RecordingSummary b;
  std::optional<std::uint32_t> requests;  ///< first step with other requests before it
  std::optional<std::uint32_t> config;    ///< first step with another configuration
  std::optional<std::uint32_t> shapes;    ///< first step in which an object has another shape, or is turned
  std::optional<std::uint32_t> state;     ///< first step with another tree
  std::optional<std::uint32_t> pairs;     ///< first step with another set of pairs
  std::optional<EventDifference> events;  ///< of any kind
  std::optional<EventDifference> operators;  ///< the first operator that acted or was refused differently

  std::optional<TheirDifference> theirs;    ///< of imports: their pairs
  std::optional<std::uint32_t> verdicts;    ///< of imports: first step with another judgement of them
  std::optional<std::uint32_t> structures;  ///< of imports: first step with another structure, or with none
  std::optional<std::uint32_t> step_names;  ///< the first step of another name
  std::vector<std::string> steps_only_a;    ///< names of steps that only one has, if either names its steps
  std::vector<std::string> steps_only_b;
  std::vector<std::string> objects_only_a;  ///< ids of objects that only one has or names
  std::vector<std::string> objects_only_b;
  bool object_names = false;          ///< objects have other names, labels or colours
  std::vector<std::string> declared;  ///< what was declared, rounded or decided otherwise, a line each

  [[nodiscard]] bool one_unfinished() const { return a.complete != b.complete; }
  /// What came after the last step of either could not be compared.
  [[nodiscard]] bool both_unfinished() const { return !a.complete && !b.complete; }
  /// What is said of what differs nowhere.
  [[nodiscard]] const char* same_words() const {
    return steps_only_a.empty() && steps_only_b.empty() ? "are the same"
                                                        : "are the same in the steps that both have";
  }
  /// Of two that are unfinished: as far as they go.
  [[nodiscard]] bool same() const {
    return !requests && !config && !shapes && !state && !pairs && !events && !theirs && !verdicts &&
           !structures && !step_names && !object_names && declared.empty() && a.steps == b.steps &&
           !one_unfinished();
  }
};

template <int D>
RecordingComparison compare(RecordingReader<D>& a, RecordingReader<D>& b);

}  // namespace kerf
