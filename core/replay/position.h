#pragma once

#include <compare>
#include <cstdint>
#include <string>

#include "core/trace/event.h"

namespace kerf {

/// A moment of a run: right after an event, or the end of a step, which comes after its last event.
struct Position {
  static constexpr std::uint64_t kEnd = UINT64_MAX;

  std::uint32_t step = 0;      ///< 0: before the first step
  std::uint64_t event = kEnd;  ///< id of the event; kEnd: the step is over

  static constexpr Position end_of(std::uint32_t step) { return {step, kEnd}; }
  [[nodiscard]] constexpr bool is_end() const { return event == kEnd; }
  friend constexpr auto operator<=>(const Position&, const Position&) = default;
};

/// "e1234" or "step 17": the same text in panels, on the command line and in file names.
inline std::string to_string(const Position& position, const GivenNames& names) {
  return position.is_end() ? "step " + names.step(position.step) : "e" + std::to_string(position.event);
}

/// How far one move goes.
enum class Granularity : std::uint8_t {
  run,        ///< to the end or the beginning
  step,       ///< ends of steps
  phase,      ///< beginnings of phases and ends of steps
  op,         ///< operators that acted or were refused
  event,      ///< everything that happens, and ends of steps
  candidate,  ///< the candidates of an operator that placed a partitioner, one after another
};

}  // namespace kerf
