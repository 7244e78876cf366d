#include "core/bsp/state_check.h"

#include <algorithm>

#include "core/tree/validate.h"

namespace kerf {
namespace {

template <int D>
std::string fault_of_tree(const Tree<D>& tree) {
  const std::vector<Violation> violations = validate(tree);
  if (violations.empty()) return "";
  const Violation& first = violations.front();
  return (first.node.is_none() ? "" : "n" + std::to_string(first.node.value) + ": ") + first.what;
}

/// The dead nodes, each once.
template <int D>
bool are_all_dead(const Tree<D>& tree) {
  std::vector<bool> seen(tree.slots(), false);
  for (const NodeId id : tree.unused()) {
    if (tree[id].alive || seen[id.index()]) return false;
    seen[id.index()] = true;
  }
  const auto dead = std::ranges::count_if(tree.nodes(), [](const Node<D>& node) { return !node.alive; });
  return static_cast<std::size_t>(dead) == tree.unused().size();
}

/// Whether the tree has the object as the caller knows it; while pairs of fat boxes are kept, inside its fat
/// box.
template <int D>
bool is_alike(const BspState<D>& state, ObjectId object) {
  const ObjectTable<D>& latest = state.latest;
  const ObjectTable<D>& placed = state.tree.table;
  if (latest.state(object) != placed.state(object)) return false;
  if (latest.state(object) == ObjectState::absent) return true;
  if (latest.is_fixed(object) != placed.is_fixed(object)) return false;
  if (!latest.is_placed(object)) return true;
  const bool fits = state.modes.mode() == Mode::kept ? contains(placed.box(object), latest.box(object))
                                                     : placed.box(object) == latest.box(object);
  return fits && std::equal(latest.extra(object), latest.extra(object) + extra_size<D>(latest.kind()),
                            placed.extra(object));
}

template <int D>
bool are_alike(const BspState<D>& state) {
  if (state.latest.bound() != state.tree.table.bound()) return false;
  for (std::uint32_t id = 0; id < state.latest.bound(); ++id)
    if (!is_alike(state, ObjectId{id})) return false;
  return true;
}

}  // namespace

template <int D>
std::string fault_of(const BspState<D>& state) {
  if (std::string fault = fault_of_tree(state.tree); !fault.empty()) return fault;
  if (!are_all_dead(state.tree))
    return "a node that waits for another life is alive, or waits twice, or does not wait";
  if (!state.scheduler.listed(Operator::balance).empty())
    return "a balance is listed, though it acts at once or never";
  if (!are_alike(state)) return "its objects are not those that were asked for";
  return "";
}

template std::string fault_of<2>(const BspState<2>&);
template std::string fault_of<3>(const BspState<3>&);

}  // namespace kerf
