#include "core/spatial/tree_walk.h"

#include <algorithm>
#include <functional>
#include <limits>

#include "core/base/float_mode.h"
#include "core/geometry/denormal.h"
#include "core/spatial/touch.h"

namespace kerf {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// Whether the tree stores the object in every leaf that its present box reaches.
template <int D>
bool is_stored(const ObjectTable<D>& stored, const ObjectTable<D>& now, ObjectId object) {
  if (!stored.is_placed(object)) return false;
  if (now.kind() == VolumeKind::box) return contains(stored.box(object), now.box(object));
  return stored.box(object) == now.box(object) &&
         std::equal(now.extra(object), now.extra(object) + extra_size<D>(now.kind()), stored.extra(object));
}

template <int D>
double key_of_hit(const Cast<D>& cast, const Box<D>& box) {
  return touches(cast, box) ? wide(entry_of(cast, box)) : kNever;
}

}  // namespace

template <int D>
TreeWalk<D>::TreeWalk(const Tree<D>& tree, const ObjectTable<D>& objects)
    : tree_(tree), objects_(objects), bounds_(tree.slots(), Box<D>::empty()), seen_(objects.bound(), 0) {
  const DefaultFloats floats;
  std::vector<NodeId> nodes;
  for_each_node(tree, tree.root(), [&](NodeId id) { nodes.push_back(id); });
  std::ranges::reverse(nodes);  // children come before their parents
  // Within a step the table may know an object that no leaf holds yet.
  std::vector<std::uint8_t> waits(objects.bound(), 1);
  for (const NodeId id : nodes)
    for (const Entry& entry : tree[id].entries)
      if (entry.object.index() < waits.size()) waits[entry.object.index()] = 0;
  for_each_placed(objects, [&](ObjectId object) {
    if (!is_stored(tree.table, objects, object)) waits[object.index()] = 1;
    if (waits[object.index()] != 0) waiting_.push_back(object);
  });
  for (const NodeId id : nodes) {
    Box<D>& bounds = bounds_[id.index()];
    if (!tree[id].is_leaf()) {
      bounds = join(bounds_[tree[id].left.index()], bounds_[tree[id].right.index()]);
      continue;
    }
    for (const Entry& entry : tree[id].entries)
      if (objects.is_placed(entry.object) && waits[entry.object.index()] == 0)
        bounds = join(bounds, objects.box(entry.object));
  }
}

/// The key of a node's bounds; larger than any other if the query does not reach them.
template <int D>
template <class KeyOf>
double TreeWalk<D>::key_below(NodeId node, KeyOf key_of) const {
  const Box<D>& bounds = bounds_[node.index()];
  return bounds.min[0] > bounds.max[0] ? kNever : key_of(bounds);
}

/// Tests the objects of a leaf that were not tested before.
template <int D>
template <class KeyOf, class Take>
void TreeWalk<D>::look_into(NodeId leaf, KeyOf key_of, Take take) {
  NodeVisit& visit = visits_.back();
  for (const Entry& entry : tree_[leaf].entries) {
    std::uint8_t& seen = seen_[entry.object.index()];
    if (seen != 0 || !objects_.is_placed(entry.object)) continue;
    seen = 1;
    ++visit.tested;
    const double key = key_of(objects_.box(entry.object));
    if (key < kNever && key <= bound_ && take(entry.object, key)) ++visit.found;
  }
}

/// `key_of(box)` is how near a box is, never nearer than a box around it, or infinite if the query does not
/// reach it; `take(object, key)` says whether the object is found, and may lower the bound.
template <int D>
template <class KeyOf, class Take>
void TreeWalk<D>::walk(KeyOf key_of, Take take) {
  const NearestRounding rounding;
  bound_ = std::numeric_limits<double>::max();
  std::ranges::fill(seen_, std::uint8_t{0});
  for (const ObjectId object : waiting_) {
    seen_[object.index()] = 1;
    const double key = key_of(objects_.box(object));
    if (key < kNever && key <= bound_) take(object, key);
  }
  std::vector<NodeId> todo{tree_.root()};
  while (!todo.empty()) {
    const NodeId id = todo.back();
    todo.pop_back();
    const double key = key_below(id, key_of);
    visits_.push_back({id, NodeFate::visited, 0, 0, key});
    if (key == kNever) {
      visits_.back().fate = NodeFate::apart;
    } else if (key > bound_) {
      visits_.back().fate = NodeFate::later;
    } else if (tree_[id].is_leaf()) {
      look_into(id, key_of, take);
    } else {
      const Node<D>& node = tree_[id];
      const bool left_first = key_below(node.left, key_of) <= key_below(node.right, key_of);
      todo.push_back(left_first ? node.right : node.left);
      todo.push_back(left_first ? node.left : node.right);
    }
  }
}

template <int D>
template <class Region>
QueryStatus TreeWalk<D>::walk_region(const Region& region, std::vector<ObjectId>& found) {
  visits_.clear();
  const QueryStatus status = check(region);
  if (status != QueryStatus::ok) return status;
  const auto before = static_cast<std::ptrdiff_t>(found.size());
  walk([&](const Box<D>& box) { return touches(region, box) ? 0 : kNever; },
       [&](ObjectId object, double) {
         found.push_back(object);
         return true;
       });
  std::sort(found.begin() + before, found.end());
  return status;
}

template <int D>
QueryStatus TreeWalk<D>::overlaps(const Box<D>& box, std::vector<ObjectId>& found) {
  const UsualComparisons comparisons;
  return walk_region(box, found);
}

template <int D>
QueryStatus TreeWalk<D>::overlaps(const Sphere<D>& sphere, std::vector<ObjectId>& found) {
  return walk_region(sphere, found);
}

template <int D>
QueryStatus TreeWalk<D>::overlaps(const Frustum<D>& frustum, std::vector<ObjectId>& found) {
  return walk_region(frustum, found);
}

template <int D>
QueryStatus TreeWalk<D>::hits(const Cast<D>& cast, std::vector<Hit>& found) {
  visits_.clear();
  const QueryStatus status = check(cast);
  if (status != QueryStatus::ok) return status;
  const auto before = static_cast<std::ptrdiff_t>(found.size());
  walk([&](const Box<D>& box) { return key_of_hit(cast, box); },
       [&](ObjectId object, double t) {
         found.push_back({object, static_cast<Scalar>(t)});
         return true;
       });
  std::sort(found.begin() + before, found.end(), std::less<>());
  return status;
}

template <int D>
QueryStatus TreeWalk<D>::first_hit(const Cast<D>& cast, Hit& first) {
  visits_.clear();
  const QueryStatus status = check(cast);
  if (status != QueryStatus::ok) return status;
  first = {ObjectId::none(), std::numeric_limits<Scalar>::infinity()};
  walk([&](const Box<D>& box) { return key_of_hit(cast, box); },
       [&](ObjectId object, double t) {
         const Hit hit{object, static_cast<Scalar>(t)};
         if (!(hit < first)) return false;
         first = hit;
         bound_ = t;
         return true;
       });
  return status;
}

template <int D>
QueryStatus TreeWalk<D>::nearest(const Nearest<D>& nearest, std::vector<Neighbour>& found) {
  visits_.clear();
  const QueryStatus status = check(nearest);
  if (status != QueryStatus::ok || nearest.count == 0) return status;
  const auto before = static_cast<std::ptrdiff_t>(found.size());
  const Sphere<D> reach{nearest.point, nearest.max_distance};
  walk([&](const Box<D>& box) { return touches(reach, box) ? squared_distance(nearest.point, box) : kNever; },
       [&](ObjectId object, double distance) {
         const Neighbour next{object, distance};
         const auto place = std::lower_bound(found.begin() + before, found.end(), next, std::less<>());
         if (static_cast<std::size_t>(place - found.begin() - before) == nearest.count) return false;
         found.insert(place, next);
         const std::size_t most = static_cast<std::size_t>(before) + nearest.count;
         if (found.size() > most) found.pop_back();
         if (found.size() == most) bound_ = found.back().squared_distance;
         return true;
       });
  return status;
}

template class TreeWalk<2>;
template class TreeWalk<3>;

}  // namespace kerf
