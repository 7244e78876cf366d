#include "viz/debugger/model/event_kinds.h"

#include <algorithm>

#include "core/base/overloaded.h"

namespace kerf {
namespace {

/// Of an operator, whatever it is, that acted, was refused or was listed.
EventKind kind_of_row(const OperatorRow& row) {
  if (row.kind == OperatorRow::Kind::acted) return kind_of(row.op);
  return row.kind == OperatorRow::Kind::refused ? EventKind::refused : EventKind::scheduled;
}

/// The table of operators has them without unpacking steps.
std::optional<Position> find_operator(const std::vector<OperatorRow>& rows, EventKind kind,
                                      const Position& from, bool forwards) {
  const auto position = [](const OperatorRow& row) { return Position{row.step, row.event}; };
  const auto matches = [&](const OperatorRow& row) { return kind_of_row(row) == kind; };
  const std::span<const OperatorRow> all = rows;
  if (forwards) {
    const auto later = std::ranges::upper_bound(all, from, {}, position);
    const auto found = std::find_if(later, all.end(), matches);
    return found == all.end() ? std::nullopt : std::optional(position(*found));
  }
  const auto earlier = std::make_reverse_iterator(std::ranges::lower_bound(all, from, {}, position));
  const auto found = std::find_if(earlier, all.rend(), matches);
  return found == all.rend() ? std::nullopt : std::optional(position(*found));
}

/// The condition on which the run is searched for events that the table does not have; null: it has none.
const char* condition_of(EventKind kind) {
  if (kind == EventKind::deferred) return "kind==deferred";
  if (kind == EventKind::placed) return "kind==placed || kind==all_placed";
  return kind == EventKind::phase ? "kind==phase" : nullptr;
}

}  // namespace

EventKind kind_of_event(const Event& event) {
  return std::visit(Overloaded{
                        [](const PhaseBegan&) { return EventKind::phase; },
                        [](const ObjectPlaced&) { return EventKind::placed; },
                        [](const OperatorScheduled&) { return EventKind::scheduled; },
                        [](const OperatorActed& acted) { return kind_of(acted.op); },
                        [](const OperatorRefused&) { return EventKind::refused; },
                        [](const EventsDeferred&) { return EventKind::deferred; },
                        [](const AllPlaced&) { return EventKind::placed; },
                    },
                    event.body);
}

std::optional<Position> find_event(Run& run, EventKind kind, const Position& from, bool forwards,
                                   const Run::Progress& progress) {
  if (kind <= EventKind::scheduled) return find_operator(run.operators(), kind, from, forwards);
  const char* const condition = condition_of(kind);
  if (condition == nullptr) return std::nullopt;
  return run.search(Expression::parse(condition), from, forwards, progress);
}

}  // namespace kerf
