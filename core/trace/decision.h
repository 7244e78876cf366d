#pragma once

#include <cstdint>
#include <optional>

#include "core/trace/event.h"

namespace kerf {

/// A partitioner that somebody chose.
struct ChosenPlane {
  std::uint32_t direction = 0;  ///< index in the direction set
  float offset = 0;
  friend bool operator==(const ChosenPlane&, const ChosenPlane&) = default;
};

/// What somebody decided instead of Algorithm 1 about the operator that is about to become event `event`:
/// that it does not act, or, of a split, by which partitioner.
struct Decision {
  std::uint64_t event = 0;
  Operator op = Operator::split;
  std::optional<ChosenPlane> plane;  ///< none: the operator is refused
  friend bool operator==(const Decision&, const Decision&) = default;
};

}  // namespace kerf
