#include "core/bsp/restless_pass.h"

#include <algorithm>

#include "core/base/tuning.h"
#include "core/kernels/follow_objects.h"
#include "core/tree/cell.h"
#include "core/tree/placement.h"

namespace kerf {

template <int D>
void RestlessPass<D>::run(Tree<D>& tree, const Objects& objects, KeptPairs<D>& kept, TaskPool& pool) {
  list_leaves(tree, leaves_);
  pieces_.resize(pool.pieces());
  pool.for_each(pieces_.size(), [&](std::size_t piece, std::size_t) {
    pieces_[piece].clear();
    const Slice leaves = slice(leaves_.size(), pieces_.size(), piece);
    for (std::size_t k = leaves.begin; k < leaves.end; ++k)
      follow_in(tree, objects, kept, leaves_[k], pieces_[piece]);
  });
  others_.clear();
  Counts all;
  for (const Piece& piece : pieces_) {
    others_.insert(others_.end(), piece.others.begin(), piece.others.end());
    for (const NodeId leaf : piece.touched) tree[leaf].unsorted = true;
    all.followed += piece.counts.followed;
    all.walked += piece.counts.walked;
    all.looked_up += piece.counts.looked_up;
    all.swept += piece.counts.swept;
  }
  std::ranges::sort(others_);  // the order in a leaf depends on what it went through
  cost_ = estimate(tree, all, others_.size());
}

/// In units of the time in which one entry is swept.
template <int D>
float RestlessPass<D>::estimate(const Tree<D>& tree, const Counts& counts, std::size_t others) {
  const auto entries = static_cast<float>(tree.entries());
  const auto swept = static_cast<float>(counts.swept);
  const float kept_leaves = (entries - swept) * tuning::kCostOfFiltering +
                            static_cast<float>(counts.looked_up) * tuning::kCostOfLookUp;
  const float placement = static_cast<float>(counts.followed) * tuning::kCostOfFollowing +
                          static_cast<float>(counts.walked) * tuning::kCostOfWalk +
                          static_cast<float>(others) * tuning::kCostOfReplacing;
  return (swept + kept_leaves + placement) /
         (entries + static_cast<float>(tree.objects()) * tuning::kCostOfPlacing + 1);
}

template <int D>
void RestlessPass<D>::follow_in(Tree<D>& tree, const Objects& objects, KeptPairs<D>& kept, NodeId leaf,
                                Piece& piece) {
  const std::size_t count = list_objects(tree, objects, kept, leaf, piece.objects);
  const bool is_swept = kept.are_many_restless(tree, leaf, count);
  kept.set_restless_count(tree, leaf, count);
  (is_swept ? piece.counts.swept : piece.counts.looked_up) += is_swept ? tree[leaf].entries.size() : count;
  piece.counts.followed += piece.objects.size();
  if (piece.objects.empty()) return;
  const PackedBox<D> cell = cell_of(tree, leaf);
  piece.left_over.resize(piece.objects.size());
  piece.left_over.resize(follow_objects<D>(
      {objects.latest.packed().data(), tree.table.packed().data(), objects.skins.data(), objects.flags.data(),
       cell, piece.objects.data(), piece.objects.size(), piece.left_over.data()}));
  if (piece.left_over.size() < piece.objects.size()) tree[leaf].unsorted = true;
  for (const std::uint32_t object : piece.left_over)
    if (objects.flags[object] == flag::kUnrequested && !try_follow(tree, objects, cell, {object}, piece))
      piece.others.push_back({object});
}

/// The restless objects that are followed in this leaf, and the number of all restless entries: an object in
/// several leaves is followed in the leftmost of them.
template <int D>
std::size_t RestlessPass<D>::list_objects(const Tree<D>& tree, const Objects& objects,
                                          const KeptPairs<D>& kept, NodeId leaf,
                                          std::vector<std::uint32_t>& list) {
  list.clear();
  if (kept.keeps(tree, leaf)) {
    for (const RestlessEntry& entry : kept.restless_of(leaf))
      if ((entry.apart & ~LeafView<D>::kFixedBit) == 0) list.push_back(entry.object);
    return kept.restless_of(leaf).size();
  }
  const Node<D>& node = tree[leaf];
  list.resize(node.entries.size());
  std::size_t count = 0;
  std::size_t listed = 0;
  for (const Entry& entry : node.entries) {
    const bool is_restless = (objects.flags[entry.object.index()] & flag::kUnrequested) != 0;
    const bool is_leftmost = (entry.straddle & node.right_of) == 0;
    list[listed] = entry.object.value;
    listed += static_cast<std::size_t>(static_cast<int>(is_restless) & static_cast<int>(is_leftmost));
    count += is_restless ? 1 : 0;
  }
  list.resize(listed);
  return count;
}

/// Gives the object its latest box if it stays restless and in its leaves; else changes nothing and returns
/// false.
template <int D>
bool RestlessPass<D>::try_follow(Tree<D>& tree, const Objects& objects, const PackedBox<D>& cell,
                                 ObjectId object, Piece& piece) {
  const PackedBox<D>& now = objects.latest.packed(object);
  PackedBox<D>& before = tree.table.packed()[object.index()];
  Skin skin = objects.skins[object.index()];
  skin.moved(size_and_speed(now, before).is_fast());
  if (!skin.is_restless()) return false;
  if (!contains(cell, now) || !contains(cell, before)) {
    ++piece.counts.walked;
    if (!reach_alike(tree, before.unpack(), now.unpack(), piece.touched)) return false;
  }
  objects.skins[object.index()] = skin;
  before = now;
  return true;
}

template class RestlessPass<2>;
template class RestlessPass<3>;

}  // namespace kerf
