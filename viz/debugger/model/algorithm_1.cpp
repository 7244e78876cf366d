#include "viz/debugger/model/algorithm_1.h"

#include <algorithm>

#include "core/base/counted.h"
#include "core/base/overloaded.h"
#include "core/trace/event_facts.h"

namespace kerf {
namespace {

int line_of_operator(Operator op) {
  switch (op) {
    case Operator::balance:
      return 5;
    case Operator::shift_split:
      return 14;
    case Operator::split:
      return 15;
    case Operator::swap:
      return 16;
    case Operator::merge:
      return 17;
  }
  return 0;
}

/// The line of an event; 0: it belongs to none.
int line_of(const Event& event, bool operating) {
  return std::visit(Overloaded{
                        [](const PhaseBegan& e) {
                          return e.phase == Phase::schedule ? 1 : e.phase == Phase::operate ? 13 : 0;
                        },
                        [](const OperatorScheduled& e) { return e.op == Operator::swap ? 6 : 9; },
                        [](const OperatorActed& e) { return line_of_operator(e.op); },
                        [&](const OperatorRefused& e) { return operating ? line_of_operator(e.op) : 9; },
                        [](const EventsDeferred&) { return 18; },
                        NothingFor<int, ObjectPlaced, AllPlaced>(),
                    },
                    event.body);
}

std::string what_was_decided(const Event& event) {
  const auto named = [](const auto& e, const char* what) {
    return std::string(to_string(e.op)) + " n" + std::to_string(e.node.node.value) + what;
  };
  return std::visit(
      Overloaded{
          [&](const OperatorScheduled& e) { return named(e, " listed"); },
          [&](const OperatorActed& e) { return named(e, " done"); },
          [&](const OperatorRefused& e) { return named(e, " refused: ") + std::string(to_string(e.reason)); },
          [](const EventsDeferred& e) { return counted(e.count, "waits", "wait") + " for a later step"; },
          NothingFor<std::string, PhaseBegan, ObjectPlaced, AllPlaced>(),
      },
      event.body);
}

/// Whether the tree was traversed follows from the scheduler's first tests.
std::string traversal_text(const Run& run, std::uint32_t pending_before) {
  const Config& config = run.config();
  const std::uint32_t step = run.position().step;
  if (config.budget_divisor == 0) return "operators are switched off";
  if (step % config.schedule_interval != 0)
    return "no: it is looked at every " + counted(config.schedule_interval, "step") + ", next in " +
           run.names().coming_step((step / config.schedule_interval + 1) * config.schedule_interval);
  return counted(pending_before, "was", "were") + " pending before this step";
}

}  // namespace

Algorithm1Trace trace_algorithm_1(const Run& run) {
  Algorithm1Trace trace;
  const Position& now = run.position();
  bool operating = false;
  for (const Event& event : run.events_of_step()) {
    if (event.id > now.event) break;
    if (const auto phase = phase_of(event)) operating = *phase == Phase::operate;
    const int line = line_of(event, operating);
    if (event.id == now.event) trace.line = line;
    if (line == 0) continue;
    std::string& decided = trace.decided[static_cast<std::size_t>(line - 1)];
    if (line == 1)
      decided = traversal_text(run, now.step < 2 ? 0 : run.rows()[now.step - 2].statistics.deferred);
    const std::string text = what_was_decided(event);
    if (!text.empty()) decided += (decided.empty() ? "" : "; ") + text;
  }
  return trace;
}

}  // namespace kerf
