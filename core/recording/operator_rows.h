#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/recording/database.h"
#include "core/trace/event.h"

namespace kerf {

/// What a recording's table of events says of an operator.
struct OperatorRow {
  enum class Kind : std::uint8_t { scheduled, acted, refused };
  std::uint64_t event = 0;
  std::uint32_t step = 0;
  Kind kind = Kind::acted;
  Operator op = Operator::split;
  NodeRef node;
  double shift = 0;  ///< of those that acted: by how much the offset grew ...
  Quality before;    ///< ... and the quality of the partitioner before
};

/// Everything that was scheduled, refused or done in a run, in order: without its steps, which would have to
/// be unpacked. Throws std::runtime_error as `open_recording` does.
std::vector<OperatorRow> read_operators(const std::filesystem::path& recording);
/// The same of a recording that is open, up to the end of a step.
std::vector<OperatorRow> read_operators(const Database& recording, std::uint32_t last_step);

}  // namespace kerf
