#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "tests/hard/trial.h"

namespace kerf::test {

/// How a broad phase stood a case, the mildest first.
enum class Verdict : std::uint8_t {
  not_applicable,
  exact,
  extra,     ///< reported pairs that are none
  twice,     ///< reported pairs more than once
  broken,    ///< ours: a wrong status, or a tree that breaks its promises
  missed,    ///< lost pairs
  time_out,  ///< used up its processor time
  crash,     ///< a signal, an abort, an exception, or no more memory
};
inline constexpr int kVerdictCount = 8;
std::string_view to_string(Verdict verdict);

/// What came of one trial in a process of its own.
struct Outcome {
  Verdict verdict = Verdict::not_applicable;
  Trial trial;
  std::string reason;     ///< of a crash or a time-out
  bool inferred = false;  ///< not tried: the verdict is that of an easier variant

  /// The count that belongs to the verdict; 0 where none does.
  [[nodiscard]] std::uint64_t count() const;
};

/// The verdict of a trial that came to its end. With denormals flushed to zero extra pairs are no fault.
Verdict judge(const Trial& trial, bool extra_allowed);
/// The worse verdict with its trial; figures are the worse of both.
Outcome worse(const Outcome& a, const Outcome& b);

/// "=", "+12", "2x5", "-1k", "T", "X": the verdict and its count in at most five characters. "t" is a
/// time-out that was inferred.
std::string symbol(const Outcome& outcome);

}  // namespace kerf::test
