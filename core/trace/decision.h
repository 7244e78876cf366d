#pragma once

#include <cstdint>
#include <optional>

#include "core/trace/event.h"

namespace kerf {

/// A partitioner chosen by the caller.
struct ChosenPlane {
  std::uint32_t direction = 0;  ///< index in the direction set
  float offset = 0;
  friend bool operator==(const ChosenPlane&, const ChosenPlane&) = default;
};

/// A decision that replaces Algorithm 1 for the operator that would become event `event`: it does not act,
/// or, for a split, it uses the given partitioner.
struct Decision {
  std::uint64_t event = 0;
  Operator op = Operator::split;
  std::optional<ChosenPlane> plane;  ///< none: the operator is refused
  friend bool operator==(const Decision&, const Decision&) = default;
};

}  // namespace kerf
