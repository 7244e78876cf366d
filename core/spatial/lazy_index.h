#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <mutex>
#include <new>
#include <optional>
#include <shared_mutex>
#include <utility>
#include <vector>

#include "core/objects/object_table.h"
#include "core/spatial/query.h"
#include "core/spatial/spatial_index.h"

namespace kerf {

/// What is cast, a little larger: for the exact test of an engine, which rounds. `least_reach`: what it adds
/// up has this size at least. What is too large to reckon with becomes NaN, which meets all.
template <int D>
SweptBox<D> with_slack(SweptBox<D> swept, Scalar least_reach = 0) {
  constexpr Scalar kSlack = 1e-6F;
  Scalar reach = least_reach;
  for (int i = 0; i < D; ++i) {
    const Scalar size = std::max(std::abs(swept.box.min[i]), std::abs(swept.box.max[i]));
    const Scalar sum = size + std::abs(swept.max_t * swept.displacement[i]);
    if (!(sum <= reach)) reach = sum;  // NaN, too
  }
  if (!(reach <= std::numeric_limits<Scalar>::max())) reach = std::numeric_limits<Scalar>::quiet_NaN();
  for (int i = 0; i < D; ++i) {
    swept.box.min[i] -= kSlack * reach;
    swept.box.max[i] += kSlack * reach;
  }
  return swept;
}

/// What a query may meet among boxes that change one by one between queries, as they do in a physics engine.
/// Those whose boxes changed are named to each query; all others are asked of a SpatialIndex, which is packed
/// anew when what was named would have cost as much. An index that is never asked costs nothing.
///
/// Threads: `candidates` may run at the same time, `note` and `forget` must run alone.
template <int D>
class LazyIndex {
 public:
  /// Call it when an object came or moved.
  void note(ObjectId object) noexcept {
    if (!is_packed_) return;
    try {
      mark(object);
      if (noted_.size() > objects_.bound() / 2) forget();
    } catch (const std::bad_alloc&) {
      forget();
    }
  }
  /// As if all objects had changed.
  void forget() noexcept {
    is_packed_ = false;
    is_noted_.clear();
    noted_.clear();
  }

  /// The objects whose boxes the query meets, each once, and others, some of which may be gone: test
  /// the box of each. `query`: Box<D> or Cast<D>. `bound`: one more than the largest id. `box_of(object)`:
  /// its present box, or std::nullopt.
  template <class Query, class BoxOf>
  [[nodiscard]] std::vector<ObjectId> candidates(const Query& query, std::size_t bound, const BoxOf& box_of) {
    {
      const std::shared_lock lock(mutex_);
      const std::size_t looked_at = is_packed_ ? noted_.size() : bound;
      if (is_packed_) answered_.fetch_add(1, std::memory_order_relaxed);
      if (looked_at_.fetch_add(looked_at, std::memory_order_relaxed) < looks_to_pack(bound))
        return gather(query, bound);
    }
    const std::unique_lock lock(mutex_);
    if (looked_at_ >= looks_to_pack(bound)) try_to_pack(bound, box_of);
    return gather(query, bound);
  }

  /// How far an object's box is from a point: mostly the nearest one's. Infinite if the index knows none.
  [[nodiscard]] double reach_of_nearest(const Vector<D>& point) const {
    const std::shared_lock lock(mutex_);
    Filter known;
    known.accepts = [](void* context, ObjectId object) {
      return !static_cast<const LazyIndex*>(context)->is_noted(object);
    };
    known.context = const_cast<LazyIndex*>(this);
    std::vector<Neighbour> found;
    const bool is_found =
        is_packed_ && index_.nearest({point, 1}, found, known) == QueryStatus::ok && !found.empty();
    return is_found ? std::sqrt(found.front().squared_distance) : std::numeric_limits<double>::infinity();
  }

 private:
  // To take in the boxes of objects that moved costs as much as to look at each so many times, and to build
  // anew as much as this. The next time is taken to be like the last one.
  static constexpr std::size_t kLooksAMove = 8;
  static constexpr std::size_t kLooksABuild = 64;

  /// Where all changed and the last time has paid, it is packed after one look at each.
  [[nodiscard]] std::size_t looks_to_pack(std::size_t bound) const {
    return !is_packed_ && has_paid_ ? bound : looks_a_pack_ * bound;
  }
  [[nodiscard]] bool is_noted(ObjectId object) const {
    return object.index() < is_noted_.size() && is_noted_[object.index()] != 0;
  }
  void mark(ObjectId object) {
    if (object.index() >= is_noted_.size()) is_noted_.resize(object.index() + std::size_t{1});
    if (std::exchange(is_noted_[object.index()], std::uint8_t{1}) == 0) noted_.push_back(object);
  }

  /// If memory runs out, all are looked at for as long again.
  template <class BoxOf>
  void try_to_pack(std::size_t bound, const BoxOf& box_of) {
    forget();
    looked_at_ = 0;
    try {
      pack(bound, box_of);
      is_packed_ = true;
    } catch (const std::bad_alloc&) {
      forget();
    }
  }
  template <class BoxOf>
  void pack(std::size_t bound, const BoxOf& box_of) {
    for (std::size_t i = 0; i < std::max(bound, objects_.bound()); ++i) {
      const ObjectId object{static_cast<std::uint32_t>(i)};
      const std::optional<Box<D>> box = i < bound ? box_of(object) : std::nullopt;
      if (!box) {
        static_cast<void>(objects_.remove(object));
        continue;
      }
      const bool is_new = objects_.state(object) == ObjectState::absent;
      static_cast<void>(is_new ? objects_.insert(object, *box, Mobility::moving)
                               : objects_.move(object, *box));
      if (!objects_.is_placed(object)) mark(object);  // what its box meets is for others to say
    }
    const bool moved = index_.update(objects_) == SpatialIndex<D>::Update::refit;
    looks_a_pack_ = moved ? kLooksAMove : kLooksABuild;
    has_paid_ = answered_.exchange(0) > looks_a_pack_;
  }

  template <class Query>
  std::vector<ObjectId> gather(const Query& query, std::size_t bound) const {
    std::vector<ObjectId> found;
    if (!is_packed_ || ask(query, found) != QueryStatus::ok) {
      found.resize(bound);
      for (std::size_t i = 0; i < bound; ++i) found[i] = {static_cast<std::uint32_t>(i)};
      return found;
    }
    std::erase_if(found, [this](ObjectId object) { return is_noted(object); });
    found.insert(found.end(), noted_.begin(), noted_.end());
    return found;
  }
  /// Infinite bounds are clamped, as those of the objects were.
  QueryStatus ask(Box<D> box, std::vector<ObjectId>& found) const {
    constexpr Scalar kMost = std::numeric_limits<Scalar>::max();
    for (int i = 0; i < D; ++i) {
      box.min[i] = std::clamp(box.min[i], -kMost, kMost);
      box.max[i] = std::clamp(box.max[i], -kMost, kMost);
    }
    return index_.overlaps(box, found);
  }
  QueryStatus ask(const Cast<D>& cast, std::vector<ObjectId>& found) const {
    auto take = [&found](ObjectId object) {
      found.push_back(object);
      return true;
    };
    return index_.visit(cast, make_visitor(take));
  }

  ObjectTable<D> objects_;  ///< as they were packed
  SpatialIndex<D> index_;
  std::vector<ObjectId> noted_;
  std::vector<std::uint8_t> is_noted_;  ///< by id
  bool is_packed_ = false;
  bool has_paid_ = false;
  std::size_t looks_a_pack_ = kLooksABuild;
  std::atomic<std::size_t> looked_at_ = 0;  ///< since it was packed
  std::atomic<std::size_t> answered_ = 0;   ///< by the index, since it was packed
  mutable std::shared_mutex mutex_;
};

}  // namespace kerf
