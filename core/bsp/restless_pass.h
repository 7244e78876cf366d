#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/task_pool.h"
#include "core/bsp/kept_pairs.h"
#include "core/objects/object_flags.h"
#include "core/objects/object_table.h"
#include "core/objects/skin.h"
#include "core/tree/tree.h"

namespace kerf {

/// Follows the restless objects while pairs are kept. Nothing is kept of them, so that one that stays in its
/// leaves only needs its box in the tree's table. The pass goes leaf by leaf: an object that lies in its
/// leaf's cell, before and now, needs no walk down the tree. Its memory is kept between steps.
template <int D>
class RestlessPass {
 public:
  /// What is known of all objects.
  struct Objects {
    const ObjectTable<D>& latest;
    std::vector<Skin>& skins;
    std::span<const ObjectFlags> flags;  ///< restless: kUnrequested; with other flags, it is not followed
  };

  /// Gives the tree's table the latest boxes of the objects that stay restless and in their leaves, and
  /// the kept leaves the number of their restless entries.
  void run(Tree<D>& tree, const Objects& objects, KeptPairs<D>& kept, TaskPool& pool);

  /// The other restless objects, in ascending order: they left their leaves, or have calmed.
  [[nodiscard]] std::span<const ObjectId> others() const { return others_; }
  /// What the step costs with kept pairs, over what it would cost if all leaves were swept: an estimate from
  /// the counts.
  [[nodiscard]] float cost() const { return cost_; }

 private:
  struct Counts {
    std::size_t followed = 0;   ///< objects
    std::size_t walked = 0;     ///< objects for which the tree was walked down
    std::size_t looked_up = 0;  ///< restless entries in leaves that keep pairs
    std::size_t swept = 0;      ///< entries in the other leaves
  };
  struct Piece {
    std::vector<ObjectId> others;
    std::vector<NodeId> touched;  ///< leaves in which an object stays, and some others
    Counts counts;
    std::vector<std::uint32_t> objects;
    std::vector<std::uint32_t> left_over;

    void clear() {
      others.clear();
      touched.clear();
      counts = {};
    }
  };

  static float estimate(const Tree<D>& tree, const Counts& counts, std::size_t others);

  static void follow_in(Tree<D>& tree, const Objects& objects, KeptPairs<D>& kept, NodeId leaf, Piece& piece);
  static std::size_t list_objects(const Tree<D>& tree, const Objects& objects, const KeptPairs<D>& kept,
                                  NodeId leaf, std::vector<std::uint32_t>& list);
  static bool try_follow(Tree<D>& tree, const Objects& objects, const PackedBox<D>& cell, ObjectId object,
                         Piece& piece);

  std::vector<NodeId> leaves_;
  std::vector<Piece> pieces_;
  std::vector<ObjectId> others_;
  float cost_ = 0;
};

}  // namespace kerf
