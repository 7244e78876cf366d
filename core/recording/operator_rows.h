#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "core/recording/database.h"
#include "core/recording/recording_info.h"
#include "core/trace/event.h"

namespace kerf {

/// A row of the table of events: an operator that was scheduled, refused or acted. Fields that its kind does
/// not have are zero.
struct OperatorRow {
  enum class Kind : std::uint8_t { scheduled, acted, refused };
  std::uint64_t event = 0;
  std::uint32_t step = 0;
  Kind kind = Kind::acted;
  Operator op = Operator::split;
  NodeRef node{};
  Quality before{};
  std::uint32_t left_after = 0;
  std::uint32_t right_after = 0;
  std::uint32_t direction = 0;
  float old_offset = 0;
  float new_offset = 0;
  Refusal reason = Refusal::dead_node;

  /// The growth of the offset.
  [[nodiscard]] double shift() const {
    return static_cast<double>(new_offset) - static_cast<double>(old_offset);
  }
  friend bool operator==(const OperatorRow&, const OperatorRow&) = default;
};

/// The row of an event; none for events without a row, such as placements.
std::optional<OperatorRow> operator_row(const Event& event);
/// Throws std::runtime_error for an unknown name.
Operator operator_called(const std::string& name);

/// The statement that writes a row, with a place for each column.
inline constexpr const char* kPutOperator = "INSERT INTO events VALUES(?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)";
void put(const OperatorRow& row, Statement& statement);

/// Continues the hash of the earlier rows of the same step; 0 before the first.
std::uint64_t hash_operator(const OperatorRow& row, std::uint64_t before);

/// All operators that were scheduled, refused or acted in a run, in order, without unpacking its steps.
/// Throws std::runtime_error as `open_recording` does, and for rows that are not those of the recording's
/// steps.
std::vector<OperatorRow> read_operators(const std::filesystem::path& recording);
/// The same for an open recording.
std::vector<OperatorRow> read_operators(const Database& recording, std::span<const StepRow> steps,
                                        const GivenNames& names);

}  // namespace kerf
