#include "viz/debugger/model/icicle_state.h"

#include <algorithm>
#include <iterator>

#include "core/base/overloaded.h"
#include "viz/debugger/model/recent_operators.h"

namespace kerf {
namespace {

std::set<NodeId> nodes_of(const Run& run, const Selection& selection) {
  using Nodes = std::set<NodeId>;
  const auto leaves = [&](ObjectId object) {
    const std::vector<NodeId> found = run.leaves_of(object);
    return Nodes(found.begin(), found.end());
  };
  return std::visit(
      Overloaded{[](std::monostate) { return Nodes(); }, [](NodeId node) { return Nodes{node}; },
                 [&](ObjectId object) { return leaves(object); },
                 [&](const Pair& pair) {
                   const Nodes a = leaves(pair.a);
                   const Nodes b = leaves(pair.b);
                   Nodes both;
                   std::ranges::set_intersection(a, b, std::inserter(both, both.end()));
                   return both;
                 }},
      selection);
}

}  // namespace

const TreeSnapshot& tree_of(const IcicleState& icicle, Run& run) {
  return icicle.last ? run.tree_before(icicle.last->event) : run.tree();
}

IcicleState make_icicle(Run& run, const Selection& selection, bool before) {
  IcicleState icicle;
  if (before) icicle.last = last_operator(run);
  icicle.bars = icicle_bars(tree_of(icicle, run));
  for (const IcicleBar& bar : icicle.bars) icicle.rows = std::max(icicle.rows, bar.depth + 1);
  icicle.selected = nodes_of(run, selection);
  icicle.acted = icicle.last ? std::optional(icicle.last->node.node) : run.event_node();
  if (!icicle.last) icicle.recent = recent_operators(run);
  return icicle;
}

const IcicleState& IcicleKeeper::icicle(Run& run, const Selection& selection, bool before) {
  const bool is_kept =
      run_ == &run && position_ == run.position() && selection_ == selection && before_ == before;
  if (!is_kept || icicle_.bars.empty()) icicle_ = make_icicle(run, selection, before);
  run_ = &run;
  position_ = run.position();
  selection_ = selection;
  before_ = before;
  return icicle_;
}

}  // namespace kerf
