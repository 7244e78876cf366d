#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/spatial/query.h"
#include "core/spatial/spatial_index.h"
#include "core/world/world.h"

namespace kerf {

/// Which objects take part in a query of a world.
struct WorldQueryFilter {
  std::uint32_t kinds = 0xF;  ///< bit k: those of ObjectKind k
  /// As if the query were an object with it; none: objects of every category, mask and group take part.
  std::optional<PairFilter> filter;
  /// Asked last, for objects that the query would report, and in `first_hit` and `nearest` for others that
  /// are not reported in the end, since some are nearer; an empty one accepts all. It must not throw, nor
  /// call functions of the world or the index that are not const.
  std::function<bool(Handle)> accepts;
};

struct WorldHit {
  Handle object;
  Scalar t = 0;  ///< where, in multiples of the cast's direction
  friend constexpr bool operator==(const WorldHit&, const WorldHit&) = default;
};

struct WorldNeighbour {
  Handle object;
  double squared_distance = 0;
  friend constexpr bool operator==(const WorldNeighbour&, const WorldNeighbour&) = default;
};

/// Answers queries about the boxes of a world's objects (docs/EMBEDDING.md, "Queries"): exactly, by the boxes
/// as given, fat boxes or not. A world without an index pays nothing.
///
/// Answers are those for the boxes as they were in the last `update`; an object that was removed since is not
/// found. Nothing is found before the first `update`, nor between a `restore` of the world and the next one,
/// nor in another world than that of the last one. Kinds and filters are those of the moment. Results are
/// appended, ordered by index, t or distance; a query that is refused appends nothing.
///
/// Threads: queries may run at the same time, while the world does not change. Each allocates its own memory.
template <int D>
class WorldIndex {
 public:
  /// Takes the boxes as they are, requests since the last step included. If memory runs out, new objects
  /// are not found, and all others are where they were or where they are now; nothing is found if the last
  /// update was from another world.
  void update(const World<D>& world);

  /// `Region`: Box<D>, Vector<D> (a point), Sphere<D> or Frustum<D>.
  template <class Region>
  QueryStatus overlaps(const World<D>& world, const Region& region, std::vector<Handle>& found,
                       const WorldQueryFilter& filter = {}) const;
  /// `cast`: Ray<D>, Segment<D> or SweptBox<D>.
  QueryStatus hits(const World<D>& world, const Cast<D>& cast, std::vector<WorldHit>& found,
                   const WorldQueryFilter& filter = {}) const;
  /// Of no object if nothing is hit.
  QueryStatus first_hit(const World<D>& world, const Cast<D>& cast, WorldHit& first,
                        const WorldQueryFilter& filter = {}) const;
  QueryStatus nearest(const World<D>& world, const Nearest<D>& nearest, std::vector<WorldNeighbour>& found,
                      const WorldQueryFilter& filter = {}) const;

 private:
  class Acceptance;

  [[nodiscard]] Handle handle(ObjectId object) const { return handles_[object.index()]; }

  SpatialIndex<D> index_;
  std::shared_ptr<const int> of_;     ///< the identity of its world
  std::vector<Handle> handles_;       ///< by index, as they were
  std::vector<Handle> next_handles_;  ///< of one update
};

}  // namespace kerf
