#include "viz/debugger/model/recent_operators.h"

#include <algorithm>

#include "core/trace/event_facts.h"

namespace kerf {

std::map<NodeId, double> recent_operators(Run& run) {
  std::map<NodeId, double> marked;
  const Position now = run.position();
  const TreeSnapshot& tree = run.tree();
  for (std::uint32_t age = 0; age < kMarkedSteps && age < now.step; ++age)
    for (const Event& event : run.events_of(now.step - age)) {
      if (event.id > now.event) break;
      const auto node = node_of(event);
      if (!has_acted(event) || !node || !tree.is_alive(*node)) continue;
      double& strength = marked[node->node];
      strength = std::max(strength, 1 - age / double{kMarkedSteps});
    }
  return marked;
}

std::optional<OperatorRow> last_operator(Run& run) {
  const Position now = run.position();
  std::optional<OperatorRow> last;
  for (const OperatorRow& row : run.operators()) {
    if (row.step > now.step || row.event > now.event) break;
    if (row.kind == OperatorRow::Kind::acted) last = row;
  }
  return last;
}

}  // namespace kerf
