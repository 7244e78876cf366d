#pragma once

#include <cstdint>
#include <span>

#include "core/replay/position.h"

namespace kerf {

/// The moment of another run over the same requests that corresponds to a moment of this one.
struct Counterpart {
  enum class Match : std::uint8_t {
    same,       ///< the same event happened there, or both are at the end of the step
    different,  ///< the same operator was at the same node with another outcome, or an object in other leaves
    none,       ///< there is none: the moment after the last event that has a counterpart
  };
  Position position;
  Match match = Match::none;
};

/// The moment of the other run that corresponds to `here`, a moment of this one. Within a phase the n-th
/// event of a node or object corresponds to the n-th one over there. `these` and `those` are the events of
/// the step of `here` in both runs; `those` may be empty, `last` is the other run's last step.
Counterpart find_counterpart(const Position& here, std::span<const Event> these, std::span<const Event> those,
                             std::uint32_t last);

}  // namespace kerf
