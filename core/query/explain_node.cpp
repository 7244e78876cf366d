#include "core/query/explain_node.h"

#include <algorithm>
#include <span>

#include "core/base/counted.h"
#include "core/base/float_mode.h"
#include "core/query/criteria_text.h"
#include "core/query/text.h"
#include "core/tree/criteria.h"

namespace kerf {
namespace {

template <int D>
std::vector<PathSide<D>> path_to(const Tree<D>& tree, NodeId id) {
  std::vector<PathSide<D>> path;
  for (NodeId above = tree[id].parent; !above.is_none(); id = above, above = tree[id].parent)
    path.push_back({above, tree[above].plane, tree[above].right == id});
  std::ranges::reverse(path);
  return path;
}

/// The lives of a node's slot as far as a moment knows them.
std::vector<NodeLife> lives_until(std::span<const OperatorRow> operators, NodeId id, const Position& at) {
  const auto moment = [](const OperatorRow& row) { return Position{row.step, row.event}; };
  const auto by_slot = find_node_lives(operators.first(
      static_cast<std::size_t>(std::ranges::upper_bound(operators, at, {}, moment) - operators.begin())));
  return id.index() < by_slot.size() ? by_slot[id.index()] : std::vector<NodeLife>{};
}

std::string moment_text(const GivenNames& names, std::uint32_t step, std::uint64_t event) {
  return "step " + names.step(step) + " (e" + std::to_string(event) + ")";
}

std::string life_text(const NodeLife& life, const GivenNames& names) {
  const LifeSpan& span = life.span;
  std::string text = "life " + std::to_string(life.generation) + ": from ";
  text += span.first_step == 0 ? "the beginning" : moment_text(names, span.first_step, span.first_event);
  if (span.last_step) text += " to " + moment_text(names, *span.last_step, span.last_event);
  return text + (life.divided.empty() ? ", never divided" : "");
}

template <int D>
std::string kind_text(const NodeExplanation<D>& e) {
  if (!e.quality) return "leaf with " + counted(e.node.population, "object");
  return "partitioner " + plane_text(e.node.plane) + " over " + quality_text(*e.quality);
}

template <int D>
NodeExplanation<D> explain(RecordingReader<D>& recording, const Position& at, const Tree<D>& tree,
                           const Config& config, NodeId id) {
  NodeExplanation<D> result;
  result.at = at;
  result.id = id;
  result.lives = lives_until(recording.operators(), id, at);
  result.history = node_history(recording, id, at.step);
  std::erase_if(result.history, [&](const Event& event) { return event.id > at.event; });
  result.alive = id.index() < tree.slots() && tree[id].alive;
  if (!result.alive) return result;
  result.node = tree[id];
  result.path = path_to(tree, id);
  if (!tree[id].is_leaf()) result.quality = quality(tree, id);
  result.wish = wish_text(tree, id, config, recording.info().names);
  return result;
}

}  // namespace

template <int D>
NodeExplanation<D> explain_node(Replayer<D>& replayer, std::uint32_t step, NodeId id) {
  const DefaultFloats floats;
  replayer.seek(step);
  return explain(replayer.recording(), Position::end_of(step), replayer.tree().tree(),
                 replayer.tree().config(), id);
}

template <int D>
NodeExplanation<D> explain_node(RecordingReader<D>& recording, const Position& at, const BspState<D>& state,
                                NodeId id) {
  const DefaultFloats floats;
  return explain(recording, at, state.tree, state.config, id);
}

template <int D>
std::string to_text(const NodeExplanation<D>& e, const GivenNames& names) {
  const DefaultFloats floats;
  std::string text = "after " + (e.at.is_end() ? "" : to_string(e.at, names) + " of ") + "step " +
                     names.step(e.at.step) + ", " + node_text(e.id);
  if (!e.alive) {
    text += e.lives.empty() ? " has never been used\n" : " is not alive\n";
  } else {
    text += " (life " + std::to_string(e.node.generation) + ") is at depth " + std::to_string(e.node.depth) +
            ": " + kind_text(e) + "\n" + e.wish + "\n";
    for (const PathSide<D>& side : e.path)
      text += "  " + std::string(side.right ? "right" : "left") + " of " + node_text(side.node) + ", " +
              plane_text(side.plane) + "\n";
  }
  for (const NodeLife& life : e.lives) text += life_text(life, names) + "\n";
  if (!e.history.empty()) text += "what happened to it:\n";
  for (const Event& event : e.history) text += "  " + describe(event, names) + "\n";
  return text;
}

#define KERF_INSTANTIATE(D)                                                                             \
  template NodeExplanation<D> explain_node<D>(Replayer<D>&, std::uint32_t, NodeId);                     \
  template NodeExplanation<D> explain_node<D>(RecordingReader<D>&, const Position&, const BspState<D>&, \
                                              NodeId);                                                  \
  template std::string to_text<D>(const NodeExplanation<D>&, const GivenNames&);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
