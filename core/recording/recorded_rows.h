#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/recording/database.h"
#include "core/recording/recording_info.h"

namespace kerf {

/// A row of the table of blocks, without its data.
struct BlockRow {
  std::uint32_t first_step = 0;
  std::uint32_t steps = 0;
  std::uint64_t changed = 0;
  std::uint64_t seal = 0;

  [[nodiscard]] std::uint32_t last_step() const { return first_step + steps - 1; }
};

/// A row of the table of keyframes, without its data.
struct KeyframeRow {
  std::uint32_t step = 0;
  std::uint64_t seal = 0;
};

/// A row of the table of shapes, without its data.
struct ShapeRow {
  std::uint32_t step = 0;  ///< the first in which an object has it
  std::uint64_t seal = 0;
};

/// A step with data of another engine.
struct TheirRow {
  std::uint32_t step = 0;
  std::uint64_t seal = 0;
};

/// The rows of a recording's tables, each in the order of its steps. Steps are consecutive from 1 on, and
/// events from 0 on; blocks hold every step once, and keyframes come at their ends.
struct RecordedRows {
  std::vector<StepRow> steps;
  std::vector<BlockRow> blocks;
  std::vector<KeyframeRow> keyframes;
  std::vector<TheirRow> theirs;
  std::vector<ShapeRow> shapes;  ///< by number; their steps do not fall
};

/// Throws std::runtime_error for rows that do not fit together, with the names of their steps.
RecordedRows read_rows(const Database& recording, const GivenNames& names);

/// The place where a recording is no longer as it was written.
struct ChangedPart {
  std::uint32_t step = 0;  ///< the first concerned; 0: the head of the recording
  std::string what;
};

struct FollowedChain {
  std::optional<ChangedPart> change;
  std::uint64_t end = 0;  ///< Chain::end up to the last step, or up to the change
};

/// Follows the chain of a recording (see Chain) from its head to its end.
FollowedChain follow_chain(const Database& recording, const RecordedRows& rows, const GivenNames& names);

/// A table with rows of no step, which no reader asks for. The recording must be complete: a writer adds rows
/// before their step.
std::optional<ChangedPart> find_added(const Database& recording, const RecordedRows& rows);

}  // namespace kerf
