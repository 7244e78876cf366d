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
  placed,
  phase,
  alarm,
  bookmark,
};
inline constexpr std::array<std::string_view, 12> kEventKindNames{
    "balance",   "shift-split", "split",  "swap",  "merge", "refused",
    "scheduled", "deferred",    "placed", "phase", "alarm", "bookmark"};

constexpr EventKind kind_of(Operator op) { return static_cast<EventKind>(op); }
EventKind kind_of_event(const Event& event);
inline std::string_view to_string(EventKind kind) { return kEventKindNames[static_cast<std::size_t>(kind)]; }

}  // namespace kerf
