#pragma once

#include <array>
#include <cstdint>

#include "core/trace/event.h"

namespace kerf {

/// What a tree looks like and what it has done, for captions, manifests and reports.
struct Statistics {
  std::uint32_t objects = 0;
  std::uint32_t leaves = 0;
  std::uint32_t height = 0;  ///< depth of the deepest leaf
  std::uint64_t entries = 0;
  double redundancy = 0;                                  ///< entries / objects - 1
  std::array<std::uint64_t, kOperatorCount> operators{};  ///< acted, by kind, since the beginning
  std::uint64_t refused = 0;                        ///< operators refused or dropped since the beginning
  std::uint32_t deferred = 0;                       ///< events waiting now
  std::uint64_t placed = 0;                         ///< objects that changed leaves in the last step
  std::array<double, kPhaseCount> phase_seconds{};  ///< of the last step, if they are timed; else 0

  [[nodiscard]] std::uint64_t count(Operator op) const { return operators[static_cast<std::size_t>(op)]; }
};

}  // namespace kerf
