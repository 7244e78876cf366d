#include "viz/debugger/model/state_figures.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/geometry/plane.h"

namespace kerf {
namespace {

/// Down from the root, left where both are left, as the tree compares them.
template <int D>
NodeId leaf_of_pair(const Tree<D>& tree, const Pair& pair) {
  NodeId id = tree.root();
  if (!tree.table.is_placed(pair.a) || !tree.table.is_placed(pair.b)) return NodeId::none();
  while (!tree[id].is_leaf()) {
    const Node<D>& node = tree[id];
    const Sides a = classify(tree.project(node.direction, pair.a), node.plane.offset);
    const Sides b = classify(tree.project(node.direction, pair.b), node.plane.offset);
    const bool both_left = a.left && b.left;
    if (!both_left && !(a.right && b.right)) return NodeId::none();
    id = both_left ? node.left : node.right;
  }
  return id;
}

/// Not a number for boxes that are apart.
template <int D>
double least_overlap(const ObjectTable<D>& table, const Pair& pair) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  if (!table.is_placed(pair.a) || !table.is_placed(pair.b)) return kNone;
  const Box<D> a = table.box(pair.a);
  const Box<D> b = table.box(pair.b);
  double least = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < D; ++axis)
    least = std::min(least,
                     double{std::min(a.max[axis], b.max[axis])} - double{std::max(a.min[axis], b.min[axis])});
  return least < 0 ? kNone : least;
}

/// Watches pairs over the steps up to a moment.
template <int D>
class PairAges {
 public:
  PairAges(const std::vector<Pair>& pairs, const ObjectTable<D>& begin)
      : pairs_(pairs), table_(begin), since_(pairs.size(), 0), was_(pairs.size(), 0) {
    for (std::size_t k = 0; k < pairs.size(); ++k) was_[k] = is_pair(pairs[k]) ? 1 : 0;
  }
  void advance(const StepRequests<D>& requests, std::uint32_t step) {
    std::vector<std::uint8_t> changed(table_.bound(), 0);
    for_each_request(requests, table_.kind(), [&](const ObjectRequest<D>& request) {
      apply(request, table_);
      changed.resize(std::max(changed.size(), request.object.index() + 1), 0);
      changed[request.object.index()] = 1;
    });
    const auto has_changed = [&](ObjectId id) {
      return id.index() < changed.size() && changed[id.index()] != 0;
    };
    for (std::size_t k = 0; k < pairs_.size(); ++k) {
      if (!has_changed(pairs_[k].a) && !has_changed(pairs_[k].b)) continue;
      const bool is = is_pair(pairs_[k]);
      if (is && was_[k] == 0) since_[k] = step;
      was_[k] = is ? 1 : 0;
    }
  }
  /// The step in which it became a pair; 0: it was one from the beginning.
  [[nodiscard]] std::uint32_t since(std::size_t k) const { return since_[k]; }

 private:
  [[nodiscard]] bool is_pair(const Pair& pair) const {
    return table_.is_placed(pair.a) && table_.is_placed(pair.b) && table_.is_pair(pair.a, pair.b);
  }

  const std::vector<Pair>& pairs_;
  ObjectTable<D> table_;
  std::vector<std::uint32_t> since_;
  std::vector<std::uint8_t> was_;
};

}  // namespace

template <int D>
std::vector<ObjectFigures> find_object_figures(const BspState<D>& state) {
  const ObjectTable<D>& table = state.latest;
  std::vector<std::uint32_t> leaves(table.bound(), 0);
  std::vector<std::uint32_t> pairs(table.bound(), 0);
  for_each_node(state.tree, state.tree.root(), [&](NodeId id) {
    if (!state.tree[id].is_leaf()) return;
    for (const Entry& entry : state.tree[id].entries)
      if (entry.object.index() < leaves.size()) ++leaves[entry.object.index()];
  });
  for (const Pair& pair : state.pairs)
    for (const ObjectId object : {pair.a, pair.b})
      if (object.index() < pairs.size()) ++pairs[object.index()];

  std::vector<ObjectFigures> figures;
  for_each_placed(table, [&](ObjectId object) {
    const std::size_t k = object.index();
    ObjectFigures of{object, table.is_fixed(object), leaves[k], pairs[k], {}, {}};
    const Box<D> box = table.box(object);
    for (int axis = 0; axis < D; ++axis) {
      of.centre.push_back((double{box.min[axis]} + double{box.max[axis]}) / 2);
      of.size.push_back(double{box.max[axis]} - double{box.min[axis]});
    }
    figures.push_back(std::move(of));
  });
  return figures;
}

template std::vector<ObjectFigures> find_object_figures<2>(const BspState<2>&);
template std::vector<ObjectFigures> find_object_figures<3>(const BspState<3>&);

template <int D>
std::vector<PairFigures> find_pair_figures(const BspState<D>& state, Replayer<D>& replayer,
                                           std::uint32_t step) {
  const std::uint32_t first = step > kOldestPair ? step - kOldestPair : 0;
  replayer.seek(first);
  PairAges<D> ages(state.pairs, replayer.tree().objects());
  for (std::uint32_t next = first + 1; next <= step; ++next)
    ages.advance(replayer.recording().step(next).requests, next);
  std::vector<PairFigures> figures;
  figures.reserve(state.pairs.size());
  for (std::size_t k = 0; k < state.pairs.size(); ++k) {
    const Pair& pair = state.pairs[k];
    const std::uint32_t age = step - std::max(first, ages.since(k));
    figures.push_back({leaf_of_pair(state.tree, pair), least_overlap(state.latest, pair), age});
  }
  return figures;
}

template std::vector<PairFigures> find_pair_figures<2>(const BspState<2>&, Replayer<2>&, std::uint32_t);
template std::vector<PairFigures> find_pair_figures<3>(const BspState<3>&, Replayer<3>&, std::uint32_t);

}  // namespace kerf
