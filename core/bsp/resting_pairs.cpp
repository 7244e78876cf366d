#include "core/bsp/resting_pairs.h"

#include <algorithm>
#include <span>
#include <utility>

#include "core/base/tuning.h"

namespace kerf {
namespace {

/// The list of a leaf, or none if the node is a leaf no longer, or another one.
template <int D>
std::span<const Pair> resting(const Tree<D>& tree, const KeptLeaves<D>& leaves, NodeId id) {
  if (!leaves.has(tree, id) || !tree[id].is_leaf()) return {};
  return leaves[id].resting.pairs;
}

}  // namespace

template <int D>
void RestingPairs<D>::begin_step(const Tree<D>& tree, KeptLeaves<D>& leaves, PairBuffer& pairs) {
  if (pairs.size() < size_ || wrong_ * tuning::kRestingPerWrong > size_) {
    pairs.clear();
    lay_out(tree, leaves, true, pairs);
  }
  pairs.truncate(size_);
}

/// Puts stretches behind one another: of all resting pairs, or of those that have their place already.
template <int D>
void RestingPairs<D>::lay_out(const Tree<D>& tree, KeptLeaves<D>& leaves, bool others, PairBuffer& pairs) {
  for (NodeId id{0}; id.index() < leaves.size(); ++id.value) {
    RestingList& list = leaves[id].resting;
    const std::span<const Pair> all = resting(tree, leaves, id);
    list.room = others ? all.size() : std::min(list.room, all.size());
    list.place = pairs.size();
    list.changed.clear();
    pairs.append(all.first(list.room));
  }
  size_ = pairs.size();
}

template <int D>
void RestingPairs<D>::end_step(const Tree<D>& tree, KeptLeaves<D>& leaves, PairBuffer& pairs) {
  std::size_t holes = 0;
  std::size_t behind = 0;
  for (NodeId id{0}; id.index() < leaves.size(); ++id.value) {
    RestingList& list = leaves[id].resting;
    const std::span<const Pair> all = resting(tree, leaves, id);
    for (const std::uint32_t at : list.changed)
      if (at < std::min(all.size(), list.room)) pairs.all()[list.place + at] = all[at];
    list.changed.clear();
    holes += list.room - std::min(all.size(), list.room);
    behind += all.size() - std::min(all.size(), list.room);
  }
  wrong_ = holes + behind;
  if (holes <= pairs.size() - size_) {
    if (holes > 0) close_holes(tree, leaves, pairs);
    return;
  }
  behind_.clear();
  behind_.append(std::as_const(pairs).all().subspan(size_));
  pairs.clear();
  lay_out(tree, leaves, false, pairs);
  pairs.append(std::as_const(behind_).all());
}

template <int D>
void RestingPairs<D>::close_holes(const Tree<D>& tree, KeptLeaves<D>& leaves, PairBuffer& pairs) {
  std::size_t end = pairs.size();
  for (NodeId id{0}; id.index() < leaves.size(); ++id.value) {
    const RestingList& list = leaves[id].resting;
    for (std::size_t at = resting(tree, leaves, id).size(); at < list.room; ++at)
      pairs.all()[list.place + at] = pairs.all()[--end];
  }
  pairs.truncate(end);
}

template class RestingPairs<2>;
template class RestingPairs<3>;

}  // namespace kerf
