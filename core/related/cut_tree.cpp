#include "core/related/cut_tree.h"

#include <algorithm>
#include <utility>

#include "core/objects/structure.h"

namespace kerf {

template <int D>
void CutTree<D>::clear() {
  nodes_.assign(1, Node{.region = everywhere<D>()});
  free_.clear();
  entries_ = 0;
}

template <int D>
typename CutTree<D>::Index CutTree<D>::make_node(Index parent, const Box<D>& region) {
  Node node{.parent = parent, .depth = nodes_[parent].depth + 1, .region = region};
  if (free_.empty()) {
    nodes_.push_back(std::move(node));
    return static_cast<Index>(nodes_.size() - 1);
  }
  const Index index = free_.back();
  free_.pop_back();
  nodes_[index] = std::move(node);
  return index;
}

template <int D>
void CutTree<D>::insert(Index node, ObjectId object, const Box<D>& box, std::vector<Index>& leaves) {
  if (boxes_.size() <= object.index()) boxes_.resize(object.index() + 1);
  boxes_[object.index()] = box;
  std::vector<Index> todo{node};
  while (!todo.empty()) {
    const Index next = todo.back();
    todo.pop_back();
    Node& at = nodes_[next];
    if (at.is_leaf()) {
      at.entries.push_back(object);
      ++at.updates;
      ++entries_;
      leaves.push_back(next);
      continue;
    }
    if (box.max[at.axis] >= at.cut) todo.push_back(at.above);
    if (box.min[at.axis] < at.cut) todo.push_back(at.below);
  }
}

template <int D>
void CutTree<D>::remove(Index node, ObjectId object) {
  Node& at = nodes_[node];
  if (at.is_leaf()) {
    const auto found = std::ranges::find(at.entries, object);
    *found = at.entries.back();
    at.entries.pop_back();
    ++at.updates;
    --entries_;
    return;
  }
  const Box<D>& box = boxes_[object.index()];
  const bool is_above = box.max[at.axis] >= at.cut;
  const Index above = at.above;
  if (box.min[at.axis] < at.cut) remove(at.below, object);
  if (is_above) remove(above, object);
}

template <int D>
void CutTree<D>::remove_all() {
  for (Node& node : nodes_) node.entries.clear();
  entries_ = 0;
}

template <int D>
void CutTree<D>::divide(Index leaf, const Cut& cut) {
  Box<D> below = nodes_[leaf].region;
  Box<D> above = below;
  below.max[cut.axis] = cut.at;
  above.min[cut.axis] = cut.at;
  const Index first = make_node(leaf, below);
  const Index second = make_node(leaf, above);
  Node& node = nodes_[leaf];
  node.axis = cut.axis;
  node.cut = cut.at;
  node.below = first;
  node.above = second;
  const std::vector<ObjectId> entries = std::exchange(node.entries, {});
  for (const ObjectId object : entries) {
    if (box(object).min[cut.axis] < cut.at) nodes_[first].entries.push_back(object);
    if (box(object).max[cut.axis] >= cut.at) nodes_[second].entries.push_back(object);
  }
  entries_ += nodes_[first].entries.size() + nodes_[second].entries.size() - entries.size();
}

template <int D>
void CutTree<D>::divide_crowded(Index leaf) {
  std::vector<Index> todo{leaf};
  while (!todo.empty()) {
    const Index next = todo.back();
    todo.pop_back();
    if (nodes_[next].entries.size() <= kCrowded || nodes_[next].depth >= kDeepest) continue;
    const Cut cut = median_cut(next);
    if (cut.axis < 0) continue;
    divide(next, cut);
    todo.push_back(nodes_[next].above);
    todo.push_back(nodes_[next].below);
  }
}

template <int D>
void CutTree<D>::free_below(Index node) {
  for (const Index child : {nodes_[node].below, nodes_[node].above}) {
    if (!nodes_[child].is_leaf()) free_below(child);
    entries_ -= nodes_[child].entries.size();
    nodes_[child] = Node{};
    free_.push_back(child);
  }
}

template <int D>
std::vector<ObjectId> CutTree<D>::take_out(Index node) {
  std::vector<ObjectId> objects = objects_below(node);
  if (!nodes_[node].is_leaf()) free_below(node);
  Node& leaf = nodes_[node];
  entries_ -= leaf.entries.size();
  leaf.axis = -1;
  leaf.below = leaf.above = kNone;
  leaf.entries.clear();
  return objects;
}

template <int D>
void CutTree<D>::collapse(Index node) {
  if (nodes_[node].is_leaf()) return;
  nodes_[node].entries = take_out(node);
  entries_ += nodes_[node].entries.size();
}

template <int D>
void CutTree<D>::move_cut(Index node, Scalar at) {
  const Box<D>& own = nodes_[node].region;
  nodes_[node].cut = at = std::clamp(at, own.min[nodes_[node].axis], own.max[nodes_[node].axis]);
  for (const Index child : {nodes_[node].below, nodes_[node].above}) {
    Box<D>& region = nodes_[child].region;
    region = nodes_[node].region;
    (child == nodes_[node].below ? region.max : region.min)[nodes_[node].axis] = at;
  }
}

template <int D>
std::vector<ObjectId> CutTree<D>::objects_below(Index node) const {
  std::vector<ObjectId> objects;
  std::vector<Index> todo{node};
  while (!todo.empty()) {
    const Node& next = nodes_[todo.back()];
    todo.pop_back();
    objects.insert(objects.end(), next.entries.begin(), next.entries.end());
    if (!next.is_leaf()) todo.insert(todo.end(), {next.above, next.below});
  }
  std::ranges::sort(objects);
  objects.erase(std::unique(objects.begin(), objects.end()), objects.end());
  return objects;
}

template <int D>
typename CutTree<D>::Cut CutTree<D>::median_cut(Index leaf) const {
  const std::vector<ObjectId>& entries = nodes_[leaf].entries;
  if (entries.size() < 2) return {};
  Box<D> centres = Box<D>::empty();
  for (const ObjectId object : entries) {
    const Vector<D> centre = box(object).center();
    centres = join(centres, Box<D>{centre, centre});
  }
  const Vector<D> spread = centres.extent();
  const int axis = static_cast<int>(std::ranges::max_element(spread.value) - spread.value.begin());
  std::vector<Scalar> places;
  places.reserve(entries.size());
  for (const ObjectId object : entries) places.push_back(box(object).center()[axis]);
  const auto middle = places.begin() + static_cast<std::ptrdiff_t>(places.size() / 2);
  std::ranges::nth_element(places, middle);
  // Objects reach out of a leaf, and so may their centres.
  const Box<D>& region = nodes_[leaf].region;
  if (!(*middle > region.min[axis] && *middle < region.max[axis])) return {};
  std::size_t below = 0;
  std::size_t above = 0;
  for (const ObjectId object : entries) {
    below += box(object).min[axis] < *middle ? 1 : 0;
    above += box(object).max[axis] >= *middle ? 1 : 0;
  }
  const bool pays = static_cast<double>(below + above) <= kMostGrowth * static_cast<double>(entries.size()) &&
                    below < entries.size() && above < entries.size();
  return pays ? Cut{axis, *middle} : Cut{};
}

template <int D>
bool CutTree<D>::begins_in(Index leaf, ObjectId a, ObjectId b) const {
  if (!overlaps(box(a), box(b))) return false;
  const Box<D>& region = nodes_[leaf].region;
  for (int i = 0; i < D; ++i) {
    const Scalar begin = std::max(box(a).min[i], box(b).min[i]);
    if (begin < region.min[i]) return false;  // both begin before its end, or one would not be here
  }
  return true;
}

template class CutTree<2>;
template class CutTree<3>;

}  // namespace kerf
