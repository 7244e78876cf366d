#pragma once

#include <cstdint>
#include <span>

#include "core/replay/position.h"

namespace kerf {

/// Where another run over the same requests stands while this one stands somewhere in a step.
struct Counterpart {
  enum class Match : std::uint8_t {
    same,       ///< the same has happened there, or both are at the end of the step
    different,  ///< the same operator was at the same node with another outcome, or an object in other leaves
    none,       ///< nothing of the kind: it stands after the last thing that has a counterpart
  };
  Position position;
  Match match = Match::none;
};

/// The moment of the other run that belongs to `here`, a moment of this one. Within a phase the n-th time
/// that something happens to a node or object belongs to the n-th time over there. `these` and `those` are
/// the events of the step of `here` in both runs; `those` may be empty, `last` is the other run's last step.
Counterpart find_counterpart(const Position& here, std::span<const Event> these, std::span<const Event> those,
                             std::uint32_t last);

}  // namespace kerf
