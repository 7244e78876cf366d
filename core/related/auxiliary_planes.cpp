#include "core/related/auxiliary_planes.h"

#include <algorithm>

namespace kerf {
namespace {

/// Of an object on an axis.
struct Span {
  Scalar begin = 0;
  Scalar end = 0;
};

/// How many objects lie in front of the best gap, and where it ends; 0 in front: there is none.
struct Gap {
  std::size_t before = 0;
  Scalar end = 0;
};

/// Spans by their begins.
Gap middle_gap(const std::vector<Span>& spans) {
  Gap best;
  const auto distance = [&](std::size_t before) {
    return 2 * before > spans.size() ? 2 * before - spans.size() : spans.size() - 2 * before;
  };
  Scalar reach = spans.front().end;
  for (std::size_t k = 1; k < spans.size(); ++k) {
    if (spans[k].begin > reach && (best.before == 0 || distance(k) < distance(best.before)))
      best = {k, spans[k].begin};
    reach = std::max(reach, spans[k].end);
  }
  return best;
}

}  // namespace

template <int D>
typename AuxiliaryPlanes<D>::Cut AuxiliaryPlanes<D>::gap_of(Index leaf) const {
  const CutTree<D>& tree = this->tree();
  const std::vector<ObjectId>& entries = tree[leaf].entries;
  Cut best;
  std::size_t least = 0;  // objects on the smaller side
  std::vector<Span> spans(entries.size());
  for (int axis = 0; axis < D; ++axis) {
    std::ranges::transform(entries, spans.begin(), [&](ObjectId object) {
      return Span{tree.box(object).min[axis], tree.box(object).max[axis]};
    });
    std::ranges::sort(spans, {}, &Span::begin);
    const Gap gap = middle_gap(spans);
    const std::size_t smaller = std::min(gap.before, entries.size() - gap.before);
    if (smaller <= least) continue;
    least = smaller;
    best = {axis, gap.end};
  }
  return best;
}

template <int D>
void AuxiliaryPlanes<D>::choose_planes() {
  CutTree<D>& tree = this->cuts();
  tree.clear();
  std::vector<Index> leaves;
  for (const ObjectId object : this->placed())
    tree.insert(tree.root(), object, this->table().box(object), leaves);
  groups_.clear();
  std::vector<Index> todo{tree.root()};
  while (!todo.empty()) {
    const Index next = todo.back();
    todo.pop_back();
    const bool is_small = tree[next].entries.size() <= kGroup || tree[next].depth >= CutTree<D>::kDeepest / 2;
    const Cut cut = is_small ? Cut{} : gap_of(next);
    if (cut.axis < 0) {
      groups_.push_back(next);
      continue;
    }
    tree.divide(next, cut);
    todo.insert(todo.end(), {tree[next].above, tree[next].below});
  }
  for (const Index group : groups_) tree.divide_crowded(group);
  is_group_.clear();
  for (const Index group : groups_) {
    is_group_.resize(std::max<std::size_t>(is_group_.size(), group + 1), 0);
    is_group_[group] = 1;
  }
  rebuilt_ = groups_.size();
  placed_then_ = this->placed().size();
  members_ = placed_then_;  // no cut goes through an object
}

template <int D>
void AuxiliaryPlanes<D>::find_groups(const Box<D>& box, std::vector<Index>& groups) const {
  const CutTree<D>& tree = this->tree();
  std::vector<Index> todo{tree.root()};
  while (!todo.empty()) {
    const Index next = todo.back();
    todo.pop_back();
    if (next < is_group_.size() && is_group_[next] != 0) {
      groups.push_back(next);
      continue;
    }
    if (box.min[tree[next].axis] < tree[next].cut) todo.push_back(tree[next].below);
    if (box.max[tree[next].axis] >= tree[next].cut) todo.push_back(tree[next].above);
  }
}

template <int D>
void AuxiliaryPlanes<D>::arrange() {
  CutTree<D>& tree = this->cuts();
  const auto changes = this->take_changes();
  if (groups_.empty() || this->placed().size() > 2 * placed_then_) return choose_planes();
  std::vector<Index> dirty;
  for (const std::vector<ObjectId>* const objects : {&changes.gone, &changes.moved})
    for (const ObjectId object : *objects) find_groups(tree.box(object), dirty);
  members_ -= dirty.size();
  const std::size_t left = dirty.size();
  for (const std::vector<ObjectId>* const objects : {&changes.moved, &changes.come})
    for (const ObjectId object : *objects) find_groups(this->table().box(object), dirty);
  members_ += dirty.size() - left;
  std::ranges::sort(dirty);
  dirty.erase(std::unique(dirty.begin(), dirty.end()), dirty.end());
  build_again(dirty, changes);
  const auto placed = static_cast<double>(this->placed().size());
  if (static_cast<double>(members_) > (1 + kMostStraddlers) * placed) return choose_planes();
  rebuilt_ = dirty.size();
}

template <int D>
void AuxiliaryPlanes<D>::build_again(const std::vector<Index>& dirty, const Changes& changes) {
  CutTree<D>& tree = this->cuts();
  std::vector<std::uint8_t> has_changed(this->table().bound(), 0);
  for (const std::vector<ObjectId>* const objects : {&changes.gone, &changes.moved})
    for (const ObjectId object : *objects) has_changed[object.index()] = 1;
  std::vector<Index> leaves;
  for (const Index group : dirty)
    for (const ObjectId object : tree.take_out(group))
      if (has_changed[object.index()] == 0) tree.insert(group, object, this->table().box(object), leaves);
  for (const std::vector<ObjectId>* const objects : {&changes.moved, &changes.come})
    for (const ObjectId object : *objects)
      tree.insert(tree.root(), object, this->table().box(object), leaves);
  for (const Index group : dirty) tree.divide_crowded(group);
}

template class AuxiliaryPlanes<2>;
template class AuxiliaryPlanes<3>;

}  // namespace kerf
