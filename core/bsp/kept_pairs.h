#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/base/append_buffer.h"
#include "core/bsp/leaf_pass.h"
#include "core/bsp/resting_pairs.h"
#include "core/bsp/step_context.h"
#include "core/kernels/kept_leaf.h"
#include "core/objects/object_flags.h"
#include "core/tree/tree.h"

namespace kerf {

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
  std::span<const ObjectFlags> flags;  ///< restless: kUnrequested
  bool keeps_resting;                  ///< pairs of objects without fat are kept apart, and not tested
  bool far = false;                    ///< most of the latest boxes are not in a core's own cache

  [[nodiscard]] bool is_restless(ObjectId object) const {
    return (flags[object.index()] & flag::kUnrequested) != 0;
  }
  /// Whether pairs of the object must be tested in each step (see KeptLeaf).
  [[nodiscard]] bool has_fat(ObjectId object) const {
    return !keeps_resting || !is_same(fat.packed(object), latest.packed(object));
  }
};

/// The pairs of fat boxes, leaf by leaf. As long as the boxes stay in their fat ones, the pairs of a step are
/// among them (DESIGN.md, "Speed"): a step filters those that need it. A leaf that an operator changed is
/// swept anew; an object that got another fat box is taken out of its leaves' lists and looked up again.
/// Restless objects have no kept pairs: they are looked up in each step. A leaf that has many of them keeps
/// nothing: it is swept as a whole.
template <int D>
class KeptPairs {
 public:
  /// Call it for every entry that placement changes in a leaf that keeps pairs, old places before new ones.
  void add_change(const EntryChange& change) {
    std::vector<EntryChange>& changes = changes_[change.leaf.index()];
    if (changes.empty()) touched_.push_back(change.leaf);
    changes.push_back(change);
  }
  /// Call it when placement is done: leaves that change from now on are swept anew.
  void placed(const Tree<D>& tree);
  /// Whether pairs of the leaf are kept: only then its changes must be added.
  [[nodiscard]] bool keeps(const Tree<D>& tree, NodeId leaf) const {
    return leaves_.has(tree, leaf) && !leaves_[leaf].swept;
  }
  /// The restless entries of a leaf that keeps pairs.
  [[nodiscard]] std::span<const RestlessEntry> restless_of(NodeId leaf) const {
    return leaves_[leaf].restless;
  }
  /// Whether so many restless entries are too many to keep pairs of the leaf.
  [[nodiscard]] bool are_many_restless(const Tree<D>& tree, NodeId leaf, std::size_t count) const;
  /// Call it before placement with the number of restless entries of the leaf.
  void set_restless_count(const Tree<D>& tree, NodeId leaf, std::size_t count);
  /// Call it before placement if the tree's boxes moved by the vector, each number rounded. `drift`: by how
  /// much gaps may have shrunk. As soon as all drifts together reach the slack of the leaves, the next `find`
  /// sweeps all of them, with this new `slack`.
  void shift(const Vector<D>& by, Scalar drift, Scalar slack);
  /// Forgets everything: all leaves are swept in the next `find`.
  void clear();
  /// Brings the kept pairs up to date with the tree, whose table has the fat boxes, and makes all pairs of
  /// the latest boxes. `pairs` has those of the last call, or none.
  void find(const StepContext<D>& step, const KeptObjects<D>& objects, PairBuffer& pairs);

 private:
  using Changes = std::span<const EntryChange>;
  using Objects = KeptObjects<D>;
  void renew(const Tree<D>& tree, const Objects& objects, NodeId id, LeafScratch<D>& scratch);
  void shift_leaf(const Objects& objects, KeptLeaf<D>& leaf) const;
  void patch(const Objects& objects, Changes changes, LeafScratch<D>& scratch);
  void drop_going(Changes changes, std::size_t objects, LeafScratch<D>& scratch);
  void sweep(const Tree<D>& tree, const Objects& objects, NodeId id, LeafScratch<D>& scratch);
  void find_in(const Tree<D>& tree, const Objects& objects, NodeId id, LeafScratch<D>& scratch,
               PairBuffer& pairs);

  KeptLeaves<D> leaves_;
  std::vector<std::vector<EntryChange>> changes_;  ///< by node
  std::vector<NodeId> touched_;                    ///< leaves that have changes
  RestingPairs<D> resting_;
  std::optional<Vector<D>> shift_;  ///< of the next `find`
  Scalar slack_ = 0;                ///< pairs with a gap up to this are listed, too: as candidates, or `near`
  Scalar drift_ = 0;                ///< by how much gaps may have shrunk since
  bool sweep_all_ = false;          ///< all leaves are swept in the next `find`
};

}  // namespace kerf
