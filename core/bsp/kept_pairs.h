#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/append_buffer.h"
#include "core/bsp/leaf_pass.h"
#include "core/bsp/standing_pairs.h"
#include "core/kernels/kept_leaf.h"
#include "core/objects/skin.h"
#include "core/tree/tree.h"

namespace kerf {

/// What the sweep of `leaf` reads, as the tree has it now, with boxes and mobility from `table`.
template <int D>
void view_leaf(const Tree<D>& tree, const ObjectTable<D>& table, NodeId leaf, LeafView<D>& view);
/// The same for who has the boxes already: those of the view stay as they are.
template <int D>
void view_all_but_boxes(const Tree<D>& tree, const ObjectTable<D>& table, NodeId leaf, LeafView<D>& view);
/// The `apart` bits (see LeafView) of an entry of `leaf`.
template <int D>
DepthMask apart_bits(const Node<D>& leaf, DepthMask straddle, bool fixed) {
  return (straddle & leaf.right_of) | (fixed ? LeafView<D>::kFixedBit : 0);
}

/// An object's entry that comes or goes in one leaf, or is of another fat box: then it goes and comes.
struct EntryChange {
  NodeId leaf;
  ObjectId object;
  DepthMask apart = 0;
  bool comes = false;
  bool restless = false;  ///< it was, if it goes, or is now, if it comes
};

/// What is known of all objects in a step.
template <int D>
struct KeptObjects {
  const ObjectTable<D>& fat;
  const ObjectTable<D>& latest;
  const std::vector<Skin>& skins;
  bool far;  ///< most of the latest boxes are not in a core's own cache

  [[nodiscard]] bool is_restless(ObjectId object) const { return skins[object.index()].is_restless(); }
  /// See KeptLeaf.
  [[nodiscard]] bool has_fat(ObjectId object) const {
    return fat.packed(object).lane != latest.packed(object).lane;
  }
};

/// The pairs of fat boxes, leaf by leaf. As long as the boxes stay in their fat ones, the pairs of a step are
/// among them (DESIGN.md, "Fast"): a step filters those that need it. A leaf that an operator changed is
/// swept anew; an object that got another fat box is taken out of its leaves' lists and looked up again.
/// Restless objects have no kept pairs: they are looked up in each step. Of a leaf that has many of them
/// nothing is kept, it is swept as a whole.
template <int D>
class KeptPairs {
 public:
  /// To be told of every entry that placement changes in a leaf that keeps pairs, old places before new ones.
  void note(const EntryChange& change) {
    std::vector<EntryChange>& changes = changes_[change.leaf.index()];
    if (changes.empty()) touched_.push_back(change.leaf);
    changes.push_back(change);
  }
  /// To be told when placement is done: leaves that change from now on are swept anew.
  void placed(Tree<D>& tree);
  /// Whether pairs of the leaf are kept: only then it must be told of changes.
  [[nodiscard]] bool keeps(const Tree<D>& tree, NodeId leaf) const {
    return is_known(tree, leaves_, leaf) && !leaves_[leaf.index()].swept;
  }
  /// The restless entries of a leaf that keeps pairs.
  [[nodiscard]] std::span<const RestlessEntry> restless_of(NodeId leaf) const {
    return leaves_[leaf.index()].restless;
  }
  /// To be told before placement how many restless entries a leaf has. Gives whether that is too many to keep
  /// pairs.
  bool note_restless(const Tree<D>& tree, NodeId leaf, std::size_t count);
  /// Forgets everything: all leaves are swept in the next `find`.
  void clear();
  /// Brings what is kept up to date with the tree, whose table has the fat boxes, and makes of the pairs that
  /// it gave last, or of none, all pairs of the latest boxes.
  void find(Tree<D>& tree, const ObjectTable<D>& latest, const std::vector<Skin>& skins, LeafPass<D>& pass,
            TaskPool& pool, PairBuffer& pairs);

 private:
  using Changes = std::span<const EntryChange>;
  using Objects = KeptObjects<D>;
  void renew(Tree<D>& tree, const Objects& objects, NodeId id, LeafScratch<D>& scratch);
  void patch(const Objects& objects, Changes changes, LeafScratch<D>& scratch);
  void drop_going(Changes changes, std::size_t objects, LeafScratch<D>& scratch);
  void sweep(const Tree<D>& tree, const Objects& objects, NodeId id, LeafScratch<D>& scratch);
  void find_in(const Tree<D>& tree, const Objects& objects, NodeId id, LeafScratch<D>& scratch,
               PairBuffer& pairs);

  std::vector<KeptLeaf<D>> leaves_;                ///< by node
  std::vector<std::vector<EntryChange>> changes_;  ///< by node
  std::vector<NodeId> touched_;                    ///< leaves that have changes
  StandingPairs<D> standing_;
};

extern template class KeptPairs<2>;
extern template class KeptPairs<3>;

}  // namespace kerf
