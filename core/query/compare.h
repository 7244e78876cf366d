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

/// Where two recordings first differ. Steps that only one of them has do not count; `steps` tells of them.
struct RecordingComparison {
  RecordingSummary a;
  RecordingSummary b;
  std::optional<std::uint32_t> requests;  ///< first step before which something else was asked
  std::optional<std::uint32_t> state;     ///< first step with another tree
  std::optional<std::uint32_t> pairs;     ///< first step with another set of pairs
  std::optional<std::uint32_t> events;    ///< first step in which something else happened ...
  std::string a_event;                    ///< ... and what first, in each; empty: nothing more
  std::string b_event;

  [[nodiscard]] bool same() const { return !requests && !state && !pairs && !events && a.steps == b.steps; }
};

template <int D>
RecordingComparison compare(RecordingReader<D>& a, RecordingReader<D>& b);

}  // namespace kerf
