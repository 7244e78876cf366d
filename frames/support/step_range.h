#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace kerf {

/// Which steps of a simulation become frames: `first`, `first + stride`, ... up to `last` at most.
struct StepRange {
  std::uint32_t first = 1;
  std::uint32_t last = 1000;
  std::uint32_t stride = 4;

  [[nodiscard]] std::uint32_t frames() const { return (last - first) / stride + 1; }
  [[nodiscard]] std::uint32_t step_of(std::uint32_t frame) const { return first + frame * stride; }
  friend bool operator==(const StepRange&, const StepRange&) = default;
};

inline constexpr std::uint32_t kMaxStep = 10'000'000;
/// Frame numbers have six digits.
inline constexpr std::uint32_t kMaxFrames = 1'000'000;

/// Throws UsageError, beginning with `given`, if the first step is 0 or above the last, if the stride is 0,
/// or for absurdly many.
void check(const StepRange& range, const std::string& given);

/// Reads "A:B:N" (steps A to B, a frame every N), "A:B" (every step) or "B" (1 to B, every step).
/// Throws UsageError if it is none of these, and as `check` does.
StepRange parse_steps(std::string_view text);

}  // namespace kerf
