#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/recording/recorded_rows.h"

namespace kerf {

/// Where a replay first differs from what was recorded.
struct Divergence {
  std::uint32_t step = 0;
  std::optional<std::uint64_t> event;  ///< none if the events agree and only their result differs
  std::string recorded;
  std::string replayed;
};

/// What a replay has shown.
struct Verdict {
  std::uint32_t steps = 0;  ///< replayed, up to the divergence if there is one
  std::uint64_t events = 0;
  std::uint64_t pairs = 0;
  std::uint64_t keyframes = 0;  ///< compared with the state at their step, and gone on from
  std::uint32_t judged = 0;     ///< steps whose pairs were held against the oracle's
  std::optional<ChangedPart> change;
  std::optional<Divergence> divergence;
  std::uint64_t missed = 0;  ///< pairs, by the oracle, summed over the steps
  std::uint64_t extra = 0;
  std::uint64_t twice = 0;
  std::uint32_t first_wrong_step = 0;  ///< of the pairs; 0: none
  TheirStep theirs;                    ///< somebody else's, summed over the steps; nothing unless imported
  std::vector<std::string> unchecked;  ///< what was not looked at

  /// The recording is as it was written, the replay is the run that was recorded, and its pairs are exact.
  /// What is said of theirs is no fault of the recording.
  [[nodiscard]] bool holds() const { return !change && !divergence && missed + extra + twice == 0; }
};

/// Checks all that a recording says: its pages and its chain; by a replay from the beginning every event,
/// figure, hash, keyframe and set of pairs; by a second one that goes on from each keyframe their hashes
/// again; and every `oracle_every`-th step's pairs, somebody else's too, by the oracle (0: never). `progress`
/// is told each step; when it returns false the rest is left. Throws std::runtime_error for a file that
/// cannot be read.
Verdict verify(const std::filesystem::path& path, std::uint32_t oracle_every = 1,
               const std::function<bool(std::uint32_t)>& progress = {});

}  // namespace kerf
