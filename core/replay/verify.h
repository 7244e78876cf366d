#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/recording/recorded_rows.h"

namespace kerf {

/// Where a replay first differs from the recording.
struct Divergence {
  std::uint32_t step = 0;
  std::optional<std::uint64_t> event;  ///< none if the events agree and only their result differs
  std::string recorded;
  std::string replayed;
};

/// The result of a replay.
struct Verdict {
  std::uint32_t steps = 0;  ///< replayed, up to the divergence if there is one
  std::uint64_t events = 0;
  std::uint64_t pairs = 0;
  std::uint64_t keyframes = 0;  ///< compared with the state at their step, and continued from
  std::string shapes;           ///< that objects have, in words; empty if none was recorded
  std::uint32_t judged = 0;     ///< steps whose pairs were compared with the oracle's
  std::optional<ChangedPart> change;
  std::optional<Divergence> divergence;
  std::uint64_t missed = 0;  ///< pairs, by the oracle, summed over the steps
  std::uint64_t extra = 0;
  std::uint64_t twice = 0;
  std::uint32_t first_wrong_step = 0;  ///< of the pairs; 0: none
  TheirStep theirs;                    ///< another engine's, summed over the steps; empty unless imported
  GivenNames names;                    ///< of the steps
  std::vector<std::string> unchecked;  ///< what was not checked

  /// The recording is as it was written, the replay is the recorded run, and its pairs are exact. Faults of
  /// another engine's pairs are no fault of the recording.
  [[nodiscard]] bool holds() const { return !change && !divergence && missed + extra + twice == 0; }
};

/// Why a verdict that holds says nothing of the pairs: the oracle was asked every so many steps, which is
/// more than there are. Empty if it was asked, or was not to be.
std::string why_unjudged(const Verdict& verdict, std::uint32_t oracle_every);

/// Checks everything in a recording: its pages and its chain; by a replay from the beginning every event,
/// figure, hash, keyframe and set of pairs; by a second one that continues from each keyframe their hashes
/// again; and every `oracle_every`-th step's pairs, another engine's too, by the oracle (0: never).
/// `progress` is called with each step, in a long one again and again; when it returns false the rest is left
/// out. Throws std::runtime_error for a file that cannot be read.
Verdict verify(const std::filesystem::path& path, std::uint32_t oracle_every = 1,
               const std::function<bool(std::uint32_t)>& progress = {});

}  // namespace kerf
