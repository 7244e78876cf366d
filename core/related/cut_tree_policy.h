#pragma once

#include <cstdint>
#include <vector>

#include "core/broad_phase/tabled.h"
#include "core/related/cut_tree.h"
#include "core/related/cut_tree_structure.h"

namespace kerf {

/// A broad phase by a tree of cuts, which a policy keeps up to date: the part that the policies share.
template <int D>
class CutTreePolicy : public Tabled<D>, public SelfDescribing<D> {
 public:
  void describe(StructureParts<D>& parts) const final { describe_cut_tree(tree_, parts); }
  /// Pairs of boxes that the last `step()` compared.
  [[nodiscard]] std::uint64_t candidates() const { return candidates_; }
  [[nodiscard]] const CutTree<D>& tree() const { return tree_; }

 protected:
  using Index = typename CutTree<D>::Index;

  /// What has changed since the step before.
  struct Changes {
    std::vector<ObjectId> gone;
    std::vector<ObjectId> come;
    std::vector<ObjectId> moved;
    [[nodiscard]] bool is_empty() const { return gone.empty() && come.empty() && moved.empty(); }
  };
  Changes take_changes();

  /// All objects anew, in a tree that is divided where they are crowded.
  void rebuild();
  /// Takes changes into the tree: what has gone or moved is removed, what has come or moved is inserted. The
  /// leaves that have got an object.
  std::vector<Index> take_in(const Changes& changes);

  CutTree<D>& cuts() { return tree_; }

 private:
  void find_pairs(PairList& pairs) final;

  CutTree<D> tree_;
  std::vector<std::uint8_t> known_;  ///< by object: it is in the tree
  std::uint64_t candidates_ = 0;
};

}  // namespace kerf
