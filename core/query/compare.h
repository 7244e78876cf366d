#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "core/recording/recording_reader.h"

namespace kerf {

/// A recording in figures over all its steps.
struct RecordingSummary {
  std::uint32_t steps = 0;
  std::array<std::uint64_t, kOperatorCount> operators{};
  std::uint64_t refused = 0;
  std::uint64_t pairs = 0;
  std::uint32_t height = 0;  ///< the greatest
  double redundancy = 0;     ///< mean of the steps
  double milliseconds = 0;   ///< median of a step
  double most_milliseconds = 0;
};

/// What happened first that did not happen in the other run; none: nothing more in that step.
struct EventDifference {
  std::uint32_t step = 0;
  std::optional<Event> a;
  std::optional<Event> b;
  friend bool operator==(const EventDifference&, const EventDifference&) = default;
};

/// Where two recordings first differ. Steps that only one of them has do not count; `steps` tells of them.
struct RecordingComparison {
  RecordingSummary a;
  RecordingSummary b;
  std::optional<std::uint32_t> requests;     ///< first step before which something else was asked
  std::optional<std::uint32_t> state;        ///< first step with another tree
  std::optional<std::uint32_t> pairs;        ///< first step with another set of pairs
  std::optional<EventDifference> events;     ///< whatever it is
  std::optional<EventDifference> operators;  ///< the first operator that acted or was refused otherwise

  [[nodiscard]] bool same() const { return !requests && !state && !pairs && !events && a.steps == b.steps; }
};

template <int D>
RecordingComparison compare(RecordingReader<D>& a, RecordingReader<D>& b);

}  // namespace kerf
