#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "core/recording/database.h"
#include "core/recording/recording_info.h"

namespace kerf {

/// A hash of words and bytes that goes on from another one.
std::uint64_t hash_words(std::span<const std::uint64_t> words, std::uint64_t seed);
std::uint64_t hash_bytes(std::span<const std::uint8_t> bytes, std::uint64_t seed);

/// Shows every change of a recording. A step's link is a hash of its row, of the link before, and of the
/// seals of what was written with the step before. A seal is a hash of such a block, keyframe, shape or rows
/// of another engine, and of the link of its step. The first link goes on from a hash of what the recording
/// says of itself; the end of the chain is kept beside `complete`. There is no secret in it: it shows damage
/// and changes, and stops no forger.
class Chain {
 public:
  enum class Part : std::uint8_t { block, keyframe, theirs, shapes };

  explicit Chain(std::uint64_t head) : link_(head) {}

  /// The link of the next step: of everything in its row but the link itself.
  std::uint64_t add(const StepRow& row);
  /// What the last step was written with; one of each part at most.
  void add(Part part, std::uint64_t seal) { seals_[static_cast<std::size_t>(part)] = seal; }
  /// The link of the last step.
  [[nodiscard]] std::uint64_t link() const { return link_; }
  /// The end of the chain, if nothing follows.
  [[nodiscard]] std::uint64_t end() const { return hash_words(seals_, link_); }

 private:
  std::uint64_t link_;
  std::array<std::uint64_t, 4> seals_{};
};

/// The seals of the parts, after the step whose link is given.
std::uint64_t seal_of_block(std::uint64_t link, std::uint32_t first_step, std::uint32_t steps,
                            std::uint64_t changed, std::span<const std::uint8_t> data);
std::uint64_t seal_of_keyframe(std::uint64_t link, std::uint32_t step, std::span<const std::uint8_t> data,
                               std::span<const std::uint8_t> looks);
std::uint64_t seal_of_shape(std::uint64_t link, std::uint32_t number, std::string_view kind,
                            std::span<const std::uint8_t> data);
/// Of all shapes that came with a step, in their order.
std::uint64_t seal_of_shapes(std::span<const std::uint64_t> seals);
/// None if the step has nothing of the kind.
std::optional<std::uint64_t> seal_of_theirs(std::uint64_t link, const Database& recording,
                                            std::uint32_t step);

/// The head of a recording's chain: a hash of the tables that are written before its first step.
std::uint64_t head_of(const Database& recording);

}  // namespace kerf
