#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/objects/object_table.h"
#include "core/spatial/block_hierarchy.h"
#include "core/spatial/query.h"

namespace kerf {

/// Called for each object that a query finds; false ends the query.
struct Visitor {
  bool (*visit)(void* context, ObjectId object) = nullptr;
  void* context = nullptr;
};

/// A visitor that calls `callable(object)`, which returns bool and must outlive the visitor.
template <class Callable>
Visitor make_visitor(Callable& callable) {
  return {[](void* context, ObjectId object) -> bool { return (*static_cast<Callable*>(context))(object); },
          &callable};
}

/// Answers queries about the objects of a broad phase: a hierarchy of boxes, sixteen side by side, which is
/// packed beside the tree and changes nothing in it.
///
///     SpatialIndex<3> index;
///     bsp.step();
///     index.update(bsp.objects());
///     std::vector<ObjectId> found;
///     if (index.overlaps(box, found) == QueryStatus::ok) ...
///
/// Answers are those for the boxes as they were in the last `update`, exactly, whatever the volumes in them:
/// a query is about the box of an object. Objects in quarantine and absent ones are never found. An object is
/// found once. Results are appended, in order; nothing is allocated if the vector has room.
///
/// Threads: queries are const and change nothing, not even behind the scenes, so any number of them may run
/// at the same time. `update` must run alone.
template <int D>
class SpatialIndex {
 public:
  using Update = typename BlockHierarchy<D>::Update;

  /// Takes the boxes of a table, for example `bsp.objects()`. Moved objects cost a pass over all boxes; the
  /// hierarchy is built anew when objects came, or when motion made it loose.
  Update update(const ObjectTable<D>& objects) { return hierarchy_.update(objects); }
  /// Makes the next `update` build anew.
  void forget() { hierarchy_.forget(); }
  /// Objects that can be found.
  [[nodiscard]] std::size_t size() const { return hierarchy_.size(); }
  [[nodiscard]] std::size_t bytes() const { return hierarchy_.bytes(); }

  // Which boxes overlap a region; appends their objects by id.
  QueryStatus overlaps(const Box<D>& box, std::vector<ObjectId>& found, const Filter& filter = {}) const;
  QueryStatus overlaps(const Vector<D>& point, std::vector<ObjectId>& found,
                       const Filter& filter = {}) const {
    return overlaps(Box<D>{point, point}, found, filter);
  }
  QueryStatus overlaps(const Sphere<D>& sphere, std::vector<ObjectId>& found,
                       const Filter& filter = {}) const;
  QueryStatus overlaps(const Frustum<D>& frustum, std::vector<ObjectId>& found,
                       const Filter& filter = {}) const;

  // Which boxes a ray, a segment or a swept box hits.
  /// Appends all, ordered by t.
  QueryStatus hits(const Cast<D>& cast, std::vector<Hit>& found, const Filter& filter = {}) const;
  /// The least of all in their order; of no object if nothing is hit.
  QueryStatus first_hit(const Cast<D>& cast, Hit& first, const Filter& filter = {}) const;

  /// Appends the nearest objects, ordered by distance.
  QueryStatus nearest(const Nearest<D>& nearest, std::vector<Neighbour>& found,
                      const Filter& filter = {}) const;

  // The same objects one at a time, in no order, until the visitor has enough.
  QueryStatus visit(const Box<D>& box, const Visitor& visitor, const Filter& filter = {}) const;
  QueryStatus visit(const Sphere<D>& sphere, const Visitor& visitor, const Filter& filter = {}) const;
  QueryStatus visit(const Frustum<D>& frustum, const Visitor& visitor, const Filter& filter = {}) const;
  QueryStatus visit(const Cast<D>& cast, const Visitor& visitor, const Filter& filter = {}) const;

 private:
  BlockHierarchy<D> hierarchy_;
};

}  // namespace kerf
