#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "core/bsp/bsp.h"
#include "tests/hard/feed.h"
#include "tests/hard/script.h"

namespace kerf::test {

/// How a broad phase stood a script so far. Plain memory, so that it survives the process that writes it.
struct Trial {
  std::uint32_t steps = 0;    ///< done
  std::uint32_t objects = 0;  ///< most of them at a time
  std::uint64_t pairs = 0;    ///< most of them in a step
  std::uint64_t missed = 0;   ///< over all steps, as the next two
  std::uint64_t extra = 0;
  std::uint64_t twice = 0;
  std::uint32_t statuses = 0;    ///< answers that were not those expected
  std::uint32_t violations = 0;  ///< ours: promises of the tree that were broken
  std::uint32_t height = 0;      ///< ours: of the deepest leaf
  double entries = 0;            ///< ours: most entries for an object
  double worst_ms = 0;           ///< processor time of the slowest step, its requests included
  double total_ms = 0;
  double limit_ms = 0;  ///< of total_ms: the process gets SIGPROF when it is used up; 0: no limit
  std::array<std::uint64_t, kOperatorCount> operators{};  ///< ours: acted
  std::uint32_t most_operators = 0;                       ///< ours: acted in one step
  std::array<char, 200> note{};                           ///< the first thing that went wrong, in words

  [[nodiscard]] bool is_exact() const { return missed + extra + twice + statuses + violations == 0; }
};

/// Writes the first thing that went wrong; later ones are dropped.
void note(Trial& trial, std::string_view text);
/// The worse of both, figure by figure.
Trial worse(const Trial& a, const Trial& b);

/// The right pairs after each step, in order. Steps with the same pairs share them.
using Truth = std::vector<std::shared_ptr<const std::vector<Pair>>>;

template <int D>
Truth find_truth(const Script<D>& script, VolumeKind kind, Feed feed);

/// Plays the script to any broad phase. `trial` is up to date after each step, should it not return.
template <int D>
void play(const Script<D>& script, const Truth& truth, BroadPhase<D>& subject, Trial& trial);

/// How our tree is tried.
struct Setting {
  VolumeKind kind = VolumeKind::box;
  Feed feed = Feed::boxes;
  std::string_view config;           ///< "K=V,...", on top of the paper's
  bool flush_to_zero = false;        ///< the processor takes denormals for zero
  std::uint32_t validate_every = 1;  ///< steps between two full checks of the tree
};

/// Plays the script to our tree, with changes of its configuration, statuses and the tree's own checks.
template <int D>
void play_kerf(const Script<D>& script, const Truth& truth, const Setting& setting, Trial& trial);

}  // namespace kerf::test
