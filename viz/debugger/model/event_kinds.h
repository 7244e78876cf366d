#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "viz/debugger/model/run.h"

namespace kerf {

/// A kind of moment that the user can go to, one after another. The operators come in the order of
/// `Operator`.
enum class EventKind : std::uint8_t {
  balance,
  shift_split,
  split,
  swap,
  merge,
  refused,
  scheduled,
  deferred,
  alarm,  ///< a step with a wrong pair
  bookmark,
  placed,
  phase,
};
inline constexpr std::array<std::string_view, 12> kEventKindNames{
    "balance",   "shift-split", "split", "swap",     "merge",  "refused",
    "scheduled", "deferred",    "alarm", "bookmark", "placed", "phase"};

constexpr EventKind kind_of(Operator op) { return static_cast<EventKind>(op); }
EventKind kind_of_event(const Event& event);
inline std::string_view to_string(EventKind kind) { return kEventKindNames[static_cast<std::size_t>(kind)]; }

/// The next event of that kind after a moment, or the last before it; none if there is none. Alarms and
/// bookmarks are not events of the run.
std::optional<Position> find_event(Run& run, EventKind kind, const Position& from, bool forwards,
                                   const Run::Progress& progress);

}  // namespace kerf
