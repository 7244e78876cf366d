#include "core/world/world_index.h"

#include <algorithm>

namespace kerf {

/// The filter of SpatialIndex for one query.
template <int D>
class WorldIndex<D>::Acceptance {
 public:
  Acceptance(const WorldIndex& index, const World<D>& world, const WorldQueryFilter& filter)
      : index_(index),
        world_(world),
        filter_(filter),
        is_of_world_(index.of_ != nullptr && index.of_ == world.identity_) {}

  [[nodiscard]] Filter filter() {
    Filter filter;
    filter.accepts = [](void* context, ObjectId object) {
      return static_cast<const Acceptance*>(context)->accepts(object);
    };
    filter.context = this;
    return filter;
  }

 private:
  [[nodiscard]] bool accepts(ObjectId object) const {
    const Handle handle = index_.handle(object);
    const ObjectDef* const def = world_.find(handle);
    return is_of_world_ && def != nullptr && (filter_.kinds >> static_cast<unsigned>(def->kind) & 1U) != 0 &&
           (!filter_.filter || may_pair(*filter_.filter, def->filter)) &&
           (!filter_.accepts || filter_.accepts(handle));
  }

  const WorldIndex& index_;
  const World<D>& world_;
  const WorldQueryFilter& filter_;
  bool is_of_world_;
};

/// Where memory ended within a change of the world, its tree may have objects that the world has not, or
/// lack some.
template <int D>
void WorldIndex<D>::update(const World<D>& world) {
  const ObjectTable<D>& objects = world.tree().objects();
  next_handles_.assign(std::max(world.bound(), objects.bound()), {});
  bool are_exact = true;
  world.for_each([&](Handle handle) {
    next_handles_[handle.index()] = handle;
    are_exact &= !is_thick(world.find(handle)->margin) && objects.is_placed({handle.index()});
  });
  if (of_ != world.identity_) of_.reset();  // boxes of the other world may stay behind if memory runs out
  if (are_exact) {
    index_.update(objects);
  } else {
    ObjectTable<D> exact = objects;
    exact.make_room(world.bound());
    world.for_each([&](Handle handle) {
      const Box<D> box = *world.box(handle);
      (void)exact.insert({handle.index()}, box, Mobility::moving);  // unless it is there
      exact.widen({handle.index()}, box);
    });
    index_.update(exact);
  }
  handles_.swap(next_handles_);
  of_ = world.identity_;
}

template <int D>
template <class Region>
QueryStatus WorldIndex<D>::overlaps(const World<D>& world, const Region& region, std::vector<Handle>& found,
                                    const WorldQueryFilter& filter) const {
  Acceptance acceptance(*this, world, filter);
  std::vector<ObjectId> objects;
  const QueryStatus status = index_.overlaps(region, objects, acceptance.filter());
  for (const ObjectId object : objects) found.push_back(handle(object));
  return status;
}

template <int D>
QueryStatus WorldIndex<D>::hits(const World<D>& world, const Cast<D>& cast, std::vector<WorldHit>& found,
                                const WorldQueryFilter& filter) const {
  Acceptance acceptance(*this, world, filter);
  std::vector<Hit> hits;
  const QueryStatus status = index_.hits(cast, hits, acceptance.filter());
  for (const Hit& hit : hits) found.push_back({handle(hit.object), hit.t});
  return status;
}

template <int D>
QueryStatus WorldIndex<D>::first_hit(const World<D>& world, const Cast<D>& cast, WorldHit& first,
                                     const WorldQueryFilter& filter) const {
  Acceptance acceptance(*this, world, filter);
  Hit hit;
  const QueryStatus status = index_.first_hit(cast, hit, acceptance.filter());
  if (status == QueryStatus::ok)
    first = hit.object.is_none() ? WorldHit{} : WorldHit{handle(hit.object), hit.t};
  return status;
}

template <int D>
QueryStatus WorldIndex<D>::nearest(const World<D>& world, const Nearest<D>& nearest,
                                   std::vector<WorldNeighbour>& found, const WorldQueryFilter& filter) const {
  Acceptance acceptance(*this, world, filter);
  std::vector<Neighbour> neighbours;
  const QueryStatus status = index_.nearest(nearest, neighbours, acceptance.filter());
  for (const Neighbour& neighbour : neighbours)
    found.push_back({handle(neighbour.object), neighbour.squared_distance});
  return status;
}

#define KERF_OVERLAPS(D, REGION)                                                                     \
  template QueryStatus WorldIndex<D>::overlaps(const World<D>&, const REGION&, std::vector<Handle>&, \
                                               const WorldQueryFilter&) const;
#define KERF_INSTANTIATE(D)     \
  template class WorldIndex<D>; \
  KERF_OVERLAPS(D, Box<D>)      \
  KERF_OVERLAPS(D, Vector<D>)   \
  KERF_OVERLAPS(D, Sphere<D>)   \
  KERF_OVERLAPS(D, Frustum<D>)
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE
#undef KERF_OVERLAPS

}  // namespace kerf
