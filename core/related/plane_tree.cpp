#include "core/related/plane_tree.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/related/cut_tree.h"

namespace kerf {
namespace {

/// What lies at the ends of the floats can make one of numbers that are none.
template <int D>
bool is_plane(const Plane<D>& plane) {
  return std::isfinite(plane.offset) &&
         std::ranges::all_of(plane.normal.value, [](Scalar x) { return x >= -1 && x <= 1; });
}

}  // namespace

template <int D>
typename PlaneTree<D>::Split PlaneTree<D>::split(std::span<const ObjectId> objects,
                                                 const Plane<D>& plane) const {
  Split split;
  for (const ObjectId object : objects) {
    const Sides sides = classify(project(plane.normal, this->table().box(object)), plane.offset);
    split.left += sides.left ? 1 : 0;
    split.right += sides.right ? 1 : 0;
  }
  return split;
}

template <int D>
bool PlaneTree<D>::pays(const Split& split, std::size_t objects) {
  return static_cast<double>(split.left + split.right) <= kMostGrowth * static_cast<double>(objects) &&
         split.left < objects && split.right < objects;
}

template <int D>
Plane<D> PlaneTree<D>::middle_plane(std::span<const ObjectId> objects, const Vector<D>& normal) {
  places_.clear();
  for (const ObjectId object : objects) {
    const Scalar place = dot(normal, this->table().box(object).center());
    places_.push_back(std::isnan(place) ? 0 : place);
  }
  const auto middle = places_.begin() + static_cast<std::ptrdiff_t>(places_.size() / 2);
  std::ranges::nth_element(places_, middle);
  return {normal, *middle};
}

template <int D>
bool PlaneTree<D>::divide(std::uint32_t leaf) {
  if (nodes_[leaf].members.size() <= kCrowded || nodes_[leaf].depth >= kDeepest) return false;
  objects_.clear();
  for (const Member& member : nodes_[leaf].members) objects_.push_back(member.object);
  const auto plane = choose(objects_);
  if (!plane || !is_plane(*plane) || !pays(split(objects_, *plane), objects_.size())) return false;
  const std::uint64_t bit = std::uint64_t{1} << nodes_[leaf].depth;
  Node left;
  left.depth = nodes_[leaf].depth + 1;
  left.turns = nodes_[leaf].turns;
  Node right = left;
  right.turns |= bit;
  for (Member member : std::exchange(nodes_[leaf].members, {})) {
    const Sides sides = classify(project(plane->normal, this->table().box(member.object)), plane->offset);
    if (sides.straddle()) member.both |= bit;
    if (sides.left) left.members.push_back(member);
    if (sides.right) right.members.push_back(member);
  }
  nodes_[leaf].plane = *plane;
  nodes_[leaf].left = static_cast<std::uint32_t>(nodes_.size());
  nodes_[leaf].right = nodes_[leaf].left + 1;
  nodes_.push_back(std::move(left));
  nodes_.push_back(std::move(right));
  return true;
}

template <int D>
void PlaneTree<D>::arrange() {
  nodes_.assign(1, {});
  for (const ObjectId object : this->placed()) nodes_[0].members.push_back({object, 0});
  for (std::uint32_t node = 0; node < nodes_.size(); ++node) divide(node);
}

/// Of two on both sides of a plane only on its left.
template <int D>
template <class Visit>
void PlaneTree<D>::for_each_test(const Node& leaf, const Visit& visit) const {
  for (std::size_t i = 0; i < leaf.members.size(); ++i)
    for (std::size_t k = i + 1; k < leaf.members.size(); ++k)
      if ((leaf.members[i].both & leaf.members[k].both & leaf.turns) == 0)
        visit(leaf.members[i].object, leaf.members[k].object);
}

template <int D>
void PlaneTree<D>::find_pairs(PairList& pairs) {
  candidates_ = 0;
  for (const Node& node : nodes_)
    for_each_test(node, [&](ObjectId a, ObjectId b) {
      ++candidates_;
      if (overlaps(this->table().box(a), this->table().box(b)) &&
          !(this->table().is_fixed(a) && this->table().is_fixed(b)))
        pairs.add(make_pair(a, b));
    });
}

template <int D>
void PlaneTree<D>::describe(StructureParts<D>& parts) const {
  parts.kind = "tree of planes";
  parts.holding = Holding::reaching;
  parts.bytes = bytes_of(nodes_) + bytes_of(objects_) + bytes_of(places_);
  for (std::uint32_t node = 0; node < nodes_.size(); ++node) {
    if (node == 0) parts.cells.push_back({everywhere<D>(), 0, kNoPart, 0, kNoPart});
    const Node& told = nodes_[node];
    *parts.bytes += bytes_of(told.members);
    for (const Member& member : told.members) parts.members.push_back({node, member.object});
    for_each_test(told, [&](ObjectId a, ObjectId b) { parts.tell_tested(a, b); });
    if (told.left == kNoPart) continue;
    // Children lie behind all nodes before them, and so do their cells.
    for (const bool right : {false, true}) {
      const auto cut = static_cast<std::uint32_t>(parts.cuts.size());
      parts.cuts.push_back({told.plane, right});
      parts.cells.push_back({everywhere<D>(), right ? told.right : told.left, node, told.depth + 1, cut});
    }
  }
  parts.end_tested();
}

template class PlaneTree<2>;
template class PlaneTree<3>;

}  // namespace kerf
