#include "core/bsp/shift_pass.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/median.h"
#include "core/base/sample_place.h"
#include "core/base/tuning.h"
#include "core/bsp/common_motion.h"
#include "core/kernels/prefetch.h"
#include "core/objects/skin.h"
#include "core/tree/cell.h"

namespace kerf {
namespace {

/// The largest coordinate of a box.
template <int D>
Scalar reach_of(const Box<D>& box) {
  Scalar reach = 0;
  for (int axis = 0; axis < D; ++axis)
    reach = std::max({reach, std::abs(box.min[axis]), std::abs(box.max[axis])});
  return reach;
}

template <int D>
PackedBox<D> packed_shift(const StepContext<D>& step) {
  return PackedBox<D>({*step.shift, *step.shift});
}

/// The distance of two floats beside a number, or more.
Scalar spacing(Scalar reach) { return reach * std::numeric_limits<Scalar>::epsilon(); }

/// The median size of a sample of the boxes; 0 if there is none.
template <int D>
Scalar typical_size(const ObjectTable<D>& table) {
  std::vector<double> sizes;
  for (std::uint32_t k = 0; k < std::min<std::size_t>(tuning::kMotionSample, table.bound()); ++k) {
    const ObjectId object{static_cast<std::uint32_t>(sample_place(k, table.bound()))};
    if (!table.is_placed(object)) continue;
    sizes.push_back(size_and_speed(table.packed(object), table.packed(object)).size);
  }
  return static_cast<Scalar>(median(std::move(sizes)));
}

/// Whether the old fat box, moved by the vector, serves for the object that went to `now`. One without fat
/// must fill it. Zeros of both signs are one number here.
template <int D>
bool follows_shift(const PackedBox<D>& fat, const PackedBox<D>& before, const PackedBox<D>& now,
                   const PackedBox<D>& by) {
  const PackedBox<D> there = moved(fat, by);
  const bool has_fat = !contains(before, fat);
  return contains(there, now) && (has_fat || contains(now, there));
}

template <int D>
void list_ancestors(const Tree<D>& tree, NodeId leaf, std::vector<LeafAncestor<D>>& ancestors) {
  ancestors.clear();
  for (NodeId id = tree[leaf].parent; !id.is_none(); id = tree[id].parent) {
    const DepthMask bit = depth_bit(tree[id].depth);
    ancestors.push_back({tree[id].plane, tree[id].direction, bit, (tree[leaf].right_of & bit) != 0});
  }
}

/// Whether the leaf below these ancestors has the entry of an object with this box, with these bits.
template <int D>
bool is_in_place(const std::vector<LeafAncestor<D>>& ancestors, DepthMask straddle, const Box<D>& box) {
  bool all = true;
  for (const auto& [plane, direction, bit, is_right] : ancestors) {
    const Sides sides = classify(project(direction, plane.normal, box), plane.offset);
    const bool straddles = (straddle & bit) != 0;
    all &= sides.right == (straddles | is_right) && sides.left == (straddles | !is_right);
  }
  return all;
}

}  // namespace

template <int D>
bool ShiftPass<D>::run(const StepContext<D>& step) {
  misplaced_.clear();
  if (!move_offsets(step) || !measure(step)) return false;
  find_left_behind(step);
  unlist_followers(step);
  exchange_offsets(step.tree);
  find_misplaced(step);
  if (!misplaced_.empty()) find_entries(step);
  move_table(step);
  list_changed(step);
  return true;
}

template <int D>
Scalar ShiftPass<D>::drift() const {
  return spacing(reach_before_) + spacing(reach_after_);
}

template <int D>
Scalar ShiftPass<D>::slack() const {
  const Scalar of_a_shift = 2 * spacing(reach_after_);
  const Scalar slack = std::min(tuning::kShiftsOfSlack * of_a_shift, size_ * Skin::kMost / 2);
  return slack > 2 * of_a_shift ? slack : 0;
}

/// Computes where the partitioners go. Returns false if an offset would not be finite.
template <int D>
bool ShiftPass<D>::move_offsets(const StepContext<D>& step) {
  const Tree<D>& tree = step.tree;
  offsets_.assign(tree.slots(), 0);
  bool are_finite = true;
  for_each_node(tree, tree.root(), [&](NodeId id) {
    if (tree[id].is_leaf()) return;
    const Scalar offset = shifted_offset(tree[id].plane, *step.shift);
    offsets_[id.index()] = offset;
    are_finite &= std::isfinite(offset);
  });
  return are_finite;
}

/// Computes how large coordinates and boxes are. Returns false if a coordinate would not be finite.
template <int D>
bool ShiftPass<D>::measure(const StepContext<D>& step) {
  const Tree<D>& tree = step.tree;
  around_.resize(step.pool().slices_of(tree.table.bound()));
  step.pool().for_slices(tree.table.bound(), [&](const Slice& slice, std::size_t piece) {
    PackedBox<D> all(Box<D>::empty());
    for (std::size_t id = slice.begin; id < slice.end; ++id)
      if (tree.table.is_placed({static_cast<std::uint32_t>(id)})) all = join(all, tree.table.packed()[id]);
    around_[piece] = all;
  });
  PackedBox<D> all(Box<D>::empty());
  for (const PackedBox<D>& box : around_) all = join(all, box);
  reach_before_ = reach_of(all.unpack());
  reach_after_ = reach_of(moved(all, packed_shift(step)).unpack());
  size_ = typical_size(tree.table);
  return std::isfinite(reach_after_);
}

/// Lists the objects of which nothing was requested, and which lie outside of their fat boxes when these
/// move.
template <int D>
void ShiftPass<D>::find_left_behind(const StepContext<D>& step) {
  left_behind_.clear();
  const PackedBox<D> by = packed_shift(step);
  const std::span<const ObjectFlags> flags = std::as_const(step.requests).flags();
  const ObjectTable<D>& latest = step.requests.latest();
  const ObjectTable<D>& table = step.tree.table;
  for (std::uint32_t id = 0; id < flags.size(); ++id) {
    if (flags[id] != 0) continue;
    const PackedBox<D>& now = latest.packed({id});
    if (!follows_shift(table.packed({id}), now, now, by)) left_behind_.push_back({id});
  }
}

/// Takes those that followed the shift off the list of changed objects. The others moved from where the shift
/// alone would have brought them; those that came did not move.
template <int D>
void ShiftPass<D>::unlist_followers(const StepContext<D>& step) {
  Requests<D>& requests = step.requests;
  const bool are_moves = requests.are_moves();
  const ObjectTable<D>& latest = requests.latest();
  const ObjectTable<D>& table = step.tree.table;
  const auto stays = [&](ObjectId object) {
    return table.is_placed(object) && latest.is_placed(object) &&
           table.is_fixed(object) == latest.is_fixed(object);
  };
  step.pool().for_slices(requests.changed().size(), [&](const Slice& slice, std::size_t) {
    const ObjectId* const changed = std::as_const(requests).changed().data();
    const PackedBox<D>* const fat = table.packed().data();
    const PackedBox<D>* const now = latest.packed().data();
    PackedBox<D>* const before = requests.before().data();
    ObjectFlags* const flags = requests.flags().data();
    const PackedBox<D> by = packed_shift(step);
    for (std::size_t k = slice.begin; k < slice.end; ++k) {
      const std::size_t id = changed[k].index();
      if (flags[id] == flag::kChanged && (are_moves || stays(changed[k])) &&
          follows_shift(fat[id], before[k], now[id], by)) {
        flags[id] = 0;
      } else {
        before[k] = table.is_placed(changed[k]) ? moved(before[k], by) : now[id];
      }
    }
  });
  requests.forget_unchanged();
}

/// Exchanges the offsets of the tree's partitioners for those that are kept here.
template <int D>
void ShiftPass<D>::exchange_offsets(Tree<D>& tree) {
  for_each_node(tree, tree.root(), [&](NodeId id) {
    if (!tree[id].is_leaf()) std::swap(tree[id].plane.offset, offsets_[id.index()]);
  });
}

/// By the partitioners after the shift and the boxes before it.
template <int D>
void ShiftPass<D>::find_misplaced(const StepContext<D>& step) {
  const Tree<D>& tree = step.tree;
  list_leaves(tree, leaves_);
  pieces_.resize(std::max(pieces_.size(), step.pool().pieces()));
  for (Piece& piece : pieces_) piece.misplaced.clear();
  step.pool().for_each(step.pool().pieces(), [&](std::size_t piece, std::size_t) {
    const Slice leaves = slice(leaves_.size(), step.pool().pieces(), piece);
    for (std::size_t k = leaves.begin; k < leaves.end; ++k)
      find_misplaced_in(step, leaves_[k], pieces_[piece]);
  });
  std::vector<ObjectId> all;
  for (const Piece& piece : pieces_) all.insert(all.end(), piece.misplaced.begin(), piece.misplaced.end());
  std::ranges::sort(all);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  for (const ObjectId object : all) misplaced_.push_back({object});
}

/// Most entries are of objects that lie wholly in the cell.
template <int D>
void ShiftPass<D>::find_misplaced_in(const StepContext<D>& step, NodeId leaf, Piece& piece) const {
  const Tree<D>& tree = step.tree;
  list_ancestors(tree, leaf, piece.ancestors);
  const PackedBox<D> cell = cell_of(tree, leaf);
  const PackedBox<D> by = packed_shift(step);
  const PackedBox<D>* const boxes = tree.table.packed().data();
  const std::span<const Entry> entries = tree[leaf].entries;
  for (std::size_t k = 0; k < entries.size(); ++k) {
    prefetch(boxes + entries[std::min(k + tuning::kPrefetchAhead, entries.size() - 1)].object.index());
    const auto& [key, object, straddle] = entries[k];
    const PackedBox<D> box = moved(boxes[object.index()], by);
    if (straddle == 0 && contains(cell, box)) continue;
    if (!is_in_place(piece.ancestors, straddle, box.unpack())) piece.misplaced.push_back(object);
  }
}

/// Where misplaced objects have their entries: by partitioners and boxes before the shift.
template <int D>
void ShiftPass<D>::find_entries(const StepContext<D>& step) {
  exchange_offsets(step.tree);
  for (Misplaced& misplaced : misplaced_)
    reach(step.tree, step.tree.table.box(misplaced.object), misplaced.reached, misplaced.passed);
  exchange_offsets(step.tree);
}

template <int D>
void ShiftPass<D>::move_table(const StepContext<D>& step) const {
  ObjectTable<D>& table = step.tree.table;
  const PackedBox<D> by = packed_shift(step);
  step.pool().for_slices(table.bound(), [&](const Slice& slice, std::size_t) {
    for (std::size_t id = slice.begin; id < slice.end; ++id)
      if (table.is_placed({static_cast<std::uint32_t>(id)}))
        table.packed()[id] = moved(table.packed()[id], by);
  });
}

/// Restless objects that are misplaced cannot be followed in their leaves.
template <int D>
void ShiftPass<D>::list_changed(const StepContext<D>& step) const {
  Requests<D>& requests = step.requests;
  for (const ObjectId object : left_behind_)
    requests.list_unasked(object, flag::kChanged, requests.latest().packed(object));
  for (const Misplaced& misplaced : misplaced_) {
    ObjectFlags& flags = requests.flags()[misplaced.object.index()];
    if ((flags & flag::kChanged) != 0) {
      flags |= flag::kMisplaced;
    } else {
      const ObjectFlags why = flags == flag::kUnrequested ? flag::kChanged | flag::kUnrequested : 0;
      requests.list_unasked(misplaced.object, static_cast<ObjectFlags>(why | flag::kMisplaced),
                            step.tree.table.packed(misplaced.object));
    }
  }
}

template <int D>
void ShiftPass<D>::append_places(ObjectId object, std::vector<Reached>& reached,
                                 std::vector<NodeId>& passed) const {
  const auto at = std::ranges::lower_bound(misplaced_, object, {}, &Misplaced::object);
  reached.insert(reached.end(), at->reached.begin(), at->reached.end());
  passed.insert(passed.end(), at->passed.begin(), at->passed.end());
}

template class ShiftPass<2>;
template class ShiftPass<3>;

}  // namespace kerf
