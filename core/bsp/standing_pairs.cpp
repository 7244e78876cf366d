#include "core/bsp/standing_pairs.h"

#include <algorithm>
#include <span>
#include <utility>

namespace kerf {
namespace {

/// The leaf's list, or none if the node is none any more, or was given to another leaf.
template <int D>
std::span<const Pair> standing(const Tree<D>& tree, const std::vector<KeptLeaf<D>>& leaves, std::size_t k) {
  const NodeId id{static_cast<std::uint32_t>(k)};
  if (!is_known(tree, leaves, id) || !tree[id].is_leaf()) return {};
  return leaves[k].standing.pairs;
}

}  // namespace

template <int D>
void StandingPairs<D>::begin_step(const Tree<D>& tree, std::vector<KeptLeaf<D>>& leaves, PairBuffer& pairs) {
  constexpr std::size_t kShare = 8;
  if (pairs.size() < size_ || wrong_ * kShare > size_) {
    pairs.clear();
    lay_out(tree, leaves, true, pairs);
  }
  pairs.truncate(size_);
}

/// Puts stretches behind one another: of all standing pairs, or of those that have their place already.
template <int D>
void StandingPairs<D>::lay_out(const Tree<D>& tree, std::vector<KeptLeaf<D>>& leaves, bool others,
                               PairBuffer& pairs) {
  for (std::size_t k = 0; k < leaves.size(); ++k) {
    StandingList& list = leaves[k].standing;
    const std::span<const Pair> all = standing(tree, leaves, k);
    list.room = others ? all.size() : std::min(list.room, all.size());
    list.place = pairs.size();
    list.changed.clear();
    pairs.append(all.first(list.room));
  }
  size_ = pairs.size();
}

template <int D>
void StandingPairs<D>::end_step(const Tree<D>& tree, std::vector<KeptLeaf<D>>& leaves, PairBuffer& pairs) {
  std::size_t holes = 0;
  std::size_t behind = 0;
  for (std::size_t k = 0; k < leaves.size(); ++k) {
    StandingList& list = leaves[k].standing;
    const std::span<const Pair> all = standing(tree, leaves, k);
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
void StandingPairs<D>::close_holes(const Tree<D>& tree, std::vector<KeptLeaf<D>>& leaves, PairBuffer& pairs) {
  std::size_t end = pairs.size();
  for (std::size_t k = 0; k < leaves.size(); ++k) {
    const StandingList& list = leaves[k].standing;
    for (std::size_t at = standing(tree, leaves, k).size(); at < list.room; ++at)
      pairs.all()[list.place + at] = pairs.all()[--end];
  }
  pairs.truncate(end);
}

template class StandingPairs<2>;
template class StandingPairs<3>;

}  // namespace kerf
