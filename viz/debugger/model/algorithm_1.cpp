#include "viz/debugger/model/algorithm_1.h"

#include <algorithm>

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
  if (const auto* began = std::get_if<PhaseBegan>(&event.body))
    return began->phase == Phase::schedule ? 1 : began->phase == Phase::operate ? 13 : 0;
  if (const auto* scheduled = std::get_if<OperatorScheduled>(&event.body))
    return scheduled->op == Operator::swap ? 6 : 9;
  if (const auto* acted = std::get_if<OperatorActed>(&event.body)) return line_of_operator(acted->op);
  if (const auto* refused = std::get_if<OperatorRefused>(&event.body))
    return operating ? line_of_operator(refused->op) : 9;
  return std::holds_alternative<EventsDeferred>(event.body) ? 18 : 0;
}

std::string what_was_decided(const Event& event) {
  const auto named = [](Operator op, NodeRef node, const char* what) {
    return std::string(to_string(op)) + " n" + std::to_string(node.node.value) + what;
  };
  if (const auto* scheduled = std::get_if<OperatorScheduled>(&event.body))
    return named(scheduled->op, scheduled->node, " listed");
  if (const auto* acted = std::get_if<OperatorActed>(&event.body))
    return named(acted->op, acted->node, " done");
  if (const auto* refused = std::get_if<OperatorRefused>(&event.body))
    return named(refused->op, refused->node, " refused: ") + std::string(to_string(refused->reason));
  if (const auto* deferred = std::get_if<EventsDeferred>(&event.body))
    return std::to_string(deferred->count) + " wait for a later step";
  return "";
}

/// Whether the tree was traversed follows from what the scheduler looks at first.
std::string traversal_text(const Run& run, std::uint32_t pending_before) {
  const Config& config = run.config();
  const std::uint32_t step = run.position().step;
  if (config.budget_divisor == 0) return "operators are switched off";
  if (step % config.schedule_interval != 0)
    return "no: it is looked at every " + std::to_string(config.schedule_interval) + " steps, next in step " +
           std::to_string((step / config.schedule_interval + 1) * config.schedule_interval);
  return std::to_string(pending_before) + " were pending before this step";
}

}  // namespace

Algorithm1Trace trace_algorithm_1(const Run& run) {
  Algorithm1Trace trace;
  const Position& now = run.position();
  bool operating = false;
  for (const Event& event : run.events_of_step()) {
    if (event.id > now.event) break;
    const auto* const began = std::get_if<PhaseBegan>(&event.body);
    if (began != nullptr) operating = began->phase == Phase::operate;
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
