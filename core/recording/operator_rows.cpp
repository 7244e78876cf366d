#include "core/recording/operator_rows.h"

#include <limits>
#include <stdexcept>
#include <string>

#include "core/recording/schema.h"

namespace kerf {
namespace {

Operator operator_called(const std::string& name) {
  for (int k = 0; k < kOperatorCount; ++k)
    if (to_string(static_cast<Operator>(k)) == name) return static_cast<Operator>(k);
  throw std::runtime_error("the recording is damaged: there is no operator '" + name + "'");
}

OperatorRow::Kind kind_called(const std::string& name) {
  if (name == "scheduled") return OperatorRow::Kind::scheduled;
  return name == "refused" ? OperatorRow::Kind::refused : OperatorRow::Kind::acted;
}

std::uint32_t natural(const Statement& row, int column) {
  return static_cast<std::uint32_t>(row.integer(column));
}

}  // namespace

std::vector<OperatorRow> read_operators(const std::filesystem::path& recording) {
  return read_operators(open_recording(recording), std::numeric_limits<std::uint32_t>::max());
}

std::vector<OperatorRow> read_operators(const Database& recording, std::uint32_t last_step) {
  std::vector<OperatorRow> operators;
  Statement rows = recording.prepare(
      "SELECT id, step, kind, op, node, generation, coalesce(new_offset - old_offset, 0), "
      "coalesce(population, 0), coalesce(left_before, 0), coalesce(right_before, 0) FROM events "
      "WHERE kind IN ('scheduled', 'acted', 'refused') AND step <= ? ORDER BY id");
  rows.bind(1, std::int64_t{last_step});
  while (rows.step()) {
    OperatorRow row;
    row.event = static_cast<std::uint64_t>(rows.integer(0));
    row.step = natural(rows, 1);
    row.kind = kind_called(rows.text(2));
    row.op = operator_called(rows.text(3));
    row.node.node = NodeId{natural(rows, 4)};
    row.node.generation = natural(rows, 5);
    row.shift = rows.real(6);
    row.before = {natural(rows, 7), natural(rows, 8), natural(rows, 9)};
    operators.push_back(row);
  }
  return operators;
}

}  // namespace kerf
