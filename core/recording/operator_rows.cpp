#include "core/recording/operator_rows.h"

#include <array>
#include <bit>
#include <string>
#include <variant>

#include "core/base/damage.h"
#include "core/base/overloaded.h"
#include "core/recording/chain.h"
#include "core/recording/recorded_rows.h"
#include "core/recording/schema.h"

namespace kerf {
namespace {

using RowKind = OperatorRow::Kind;

constexpr std::array<std::string_view, 3> kKindNames{"scheduled", "acted", "refused"};

RowKind kind_called(const std::string& name) {
  for (std::size_t k = 0; k < kKindNames.size(); ++k)
    if (kKindNames[k] == name) return static_cast<RowKind>(k);
  fail_damaged("there is no kind of event '" + name + "'");
}

Refusal refusal_called(const std::string& name) {
  for (int k = 0; k < kRefusalCount; ++k)
    if (to_string(static_cast<Refusal>(k)) == name) return static_cast<Refusal>(k);
  fail_damaged("there is no reason '" + name + "'");
}

constexpr int kFirstFigure = 6;  ///< the first column that only operators that acted fill ...
constexpr int kReason = 14;      ///< ... except the reason of a refusal

OperatorRow read_operator(const Statement& row) {
  OperatorRow result{.event = row.natural(0),
                     .step = row.small(1),
                     .kind = kind_called(row.text(2)),
                     .op = operator_called(row.text(3)),
                     .node = {NodeId{row.small(4)}, row.small(5)}};
  const bool acted = result.kind == RowKind::acted;
  for (int column = kFirstFigure; column < kReason; ++column)
    if (row.is_null(column) == acted)
      fail_damaged("e" + std::to_string(result.event) + " has figures of another kind");
  if (row.is_null(kReason) != (result.kind != RowKind::refused))
    fail_damaged("e" + std::to_string(result.event) + " has a reason of another kind");
  if (result.kind == RowKind::refused) result.reason = refusal_called(row.text(kReason));
  if (!acted) return result;
  result.before = {row.small(6), row.small(7), row.small(8)};
  result.left_after = row.small(9);
  result.right_after = row.small(10);
  result.direction = row.small(11);
  result.old_offset = row.single(12);
  result.new_offset = row.single(13);
  return result;
}

/// Compares the rows of each step with the hash that the step has of them.
class RowCheck {
 public:
  RowCheck(std::span<const StepRow> steps, const GivenNames& names) : steps_(steps), names_(names) {}

  void add(const OperatorRow& row) {
    while (at_ < steps_.size() && row.event >= steps_[at_].first_event + steps_[at_].events) end_step();
    const bool fits = at_ < steps_.size() && row.step == steps_[at_].step && row.event >= next_;
    if (!fits) fail_damaged("e" + std::to_string(row.event) + " is in the wrong step");
    next_ = row.event + 1;
    hash_ = hash_operator(row, hash_);
  }
  void finish() {
    while (at_ < steps_.size()) end_step();
  }

 private:
  void end_step() {
    if (steps_[at_].operators_hash != hash_)
      fail_damaged("the events of step " + names_.step(steps_[at_].step) +
                   " are not those that were written");
    ++at_;
    hash_ = 0;
  }

  std::span<const StepRow> steps_;
  const GivenNames& names_;
  std::size_t at_ = 0;
  std::uint64_t hash_ = 0;
  std::uint64_t next_ = 0;  ///< the least number that the next event may have
};

}  // namespace

std::optional<OperatorRow> operator_row(const Event& event) {
  using Row = std::optional<OperatorRow>;
  const auto row_of = [&event](RowKind kind, Operator op, const NodeRef& node) {
    return OperatorRow{.event = event.id, .step = event.step, .kind = kind, .op = op, .node = node};
  };
  return std::visit(
      Overloaded{
          [&](const OperatorActed& e) {
            OperatorRow row = row_of(RowKind::acted, e.op, e.node);
            row.before = e.before;
            row.left_after = e.after.left;
            row.right_after = e.after.right;
            row.direction = e.direction;
            row.old_offset = e.old_offset;
            row.new_offset = e.new_offset;
            return Row(row);
          },
          [&](const OperatorRefused& e) {
            OperatorRow row = row_of(RowKind::refused, e.op, e.node);
            row.reason = e.reason;
            return Row(row);
          },
          [&](const OperatorScheduled& e) { return Row(row_of(RowKind::scheduled, e.op, e.node)); },
          NothingFor<Row, PhaseBegan, ObjectPlaced, EventsDeferred, AllPlaced>(),
      },
      event.body);
}

Operator operator_called(const std::string& name) {
  for (int k = 0; k < kOperatorCount; ++k)
    if (to_string(static_cast<Operator>(k)) == name) return static_cast<Operator>(k);
  fail_damaged("there is no operator '" + name + "'");
}

void put(const OperatorRow& row, Statement& statement) {
  statement.clear();
  statement.bind(1, static_cast<std::int64_t>(row.event)).bind(2, std::int64_t{row.step});
  statement.bind(3, kKindNames[static_cast<std::size_t>(row.kind)]).bind(4, to_string(row.op));
  statement.bind(5, std::int64_t{row.node.node.value}).bind(6, std::int64_t{row.node.generation});
  if (row.kind == RowKind::acted) {
    int place = kFirstFigure;
    for (const std::uint32_t x : {row.before.population, row.before.left, row.before.right, row.left_after,
                                  row.right_after, row.direction})
      statement.bind(++place, std::int64_t{x});
    statement.bind(13, static_cast<double>(row.old_offset)).bind(14, static_cast<double>(row.new_offset));
  }
  if (row.kind == RowKind::refused) statement.bind(kReason + 1, to_string(row.reason));
  statement.run();
}

std::uint64_t hash_operator(const OperatorRow& row, std::uint64_t before) {
  const auto word = [](std::uint32_t high, std::uint32_t low) { return std::uint64_t{high} << 32U | low; };
  const auto bits = [](float x) { return std::bit_cast<std::uint32_t>(x + 0.0F); };  // SQLite has one zero
  const auto kinds = static_cast<std::uint32_t>(row.kind) << 16U | static_cast<std::uint32_t>(row.op) << 8U |
                     static_cast<std::uint32_t>(row.reason);
  return hash_words(
      std::array{row.event, word(row.step, kinds), word(row.node.node.value, row.node.generation),
                 word(row.before.population, row.before.left), word(row.before.right, row.left_after),
                 word(row.right_after, row.direction), word(bits(row.old_offset), bits(row.new_offset))},
      before);
}

std::vector<OperatorRow> read_operators(const std::filesystem::path& recording) {
  Database database = open_recording(recording);
  database.execute("BEGIN");  // rows of one moment, even while it is being written
  const GivenNames names = read_info(database).names;
  return read_operators(database, read_rows(database, names).steps, names);
}

std::vector<OperatorRow> read_operators(const Database& recording, std::span<const StepRow> steps,
                                        const GivenNames& names) {
  std::vector<OperatorRow> operators;
  RowCheck check(steps, names);
  // A writer may have added more since the steps were read.
  Statement rows = recording.prepare("SELECT * FROM events WHERE step <= ? ORDER BY id");
  rows.bind(1, std::int64_t{steps.empty() ? 0 : steps.back().step});
  while (rows.step()) {
    operators.push_back(read_operator(rows));
    check.add(operators.back());
  }
  check.finish();
  return operators;
}

}  // namespace kerf
