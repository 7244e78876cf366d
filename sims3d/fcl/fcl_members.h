#pragma once

#include <fcl/broadphase/broadphase_collision_manager.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "core/spatial/lazy_index.h"
#include "core/world/handle.h"
#include "sims3d/fcl/fcl_box.h"

namespace kerf {

/// A member of a manager, and how far its box is from what is asked about.
template <typename S>
struct NearMember {
  S apart;
  std::size_t place;
  fcl::CollisionObject<S>* object;
};

/// Offers members that are nearer than `least`, the nearest boxes first, so that few others are nearer than
/// what their objects are apart: looks into a box that grows, until nothing nearer can be outside. Returns
/// whether an offer ended the search.
///
/// `reach`: how far it looks first, which is little if what is there is mostly farther. `list(begin, reach,
/// near)` lists whatever is not nearer than `begin` but nearer than `reach`, and more, and returns whether
/// nothing that is farther is missing. An offer may lower `least`.
template <typename S, class List, class Offer>
bool offer_nearest_first(S reach, const S& least, const List& list, const Offer& offer) {
  const auto is_farther = [](const auto& a, const auto& b) { return a.apart > b.apart; };
  S offered = 0;  // all that is nearer
  for (std::vector<NearMember<S>> near;; offered = reach, reach *= 2) {
    reach = std::min(reach, least);
    near.clear();
    const bool are_all = list(offered, reach, near);
    std::ranges::make_heap(near, is_farther);  // few of them are offered
    while (!near.empty() && near.front().apart < (are_all ? least : std::min(reach, least))) {
      if (offer(near.front())) return true;
      std::ranges::pop_heap(near, is_farther);
      near.pop_back();
    }
    if (are_all || !(reach < least)) return false;
  }
}

/// The objects of a manager, and which of them meet a box or are near it.
template <typename S>
struct FclMembers {
  using Object = fcl::CollisionObject<S>;
  struct Member {
    Object* object = nullptr;
    Handle handle;
    Box<3> box;
  };

  std::vector<Member> list;  ///< by index of the handle; without an object: free
  std::unique_ptr<LazyIndex<3>> index = std::make_unique<LazyIndex<3>>();

  /// Null where there is none, since a callback has unregistered it.
  [[nodiscard]] Object* object_at(std::size_t place) const {
    return place < list.size() ? list[place].object : nullptr;
  }
  [[nodiscard]] Object* object_of(Handle handle) const {
    return handle.index() < list.size() && list[handle.index()].handle == handle ? object_at(handle.index())
                                                                                 : nullptr;
  }
  /// What may overlap a box, each once, and others, some of which may be gone.
  [[nodiscard]] std::vector<ObjectId> candidates(const fcl::AABB<S>& box) const {
    const auto box_of = [this](ObjectId id) {
      const Member& member = list[id.index()];
      return member.object != nullptr ? std::optional(member.box) : std::nullopt;
    };
    return index->candidates(to_box(box), list.size(), box_of);
  }
  /// Offers the members nearer to a box than `least` for which `is_due(place)` holds, as
  /// `offer_nearest_first` does. `count`: of all members.
  template <class IsDue, class Offer>
  bool offer_nearest(const fcl::AABB<S>& from, std::size_t count, const S& least, const IsDue& is_due,
                     const Offer& offer) const {
    const auto list_near = [&](S begin, S reach, std::vector<NearMember<S>>& near) {
      std::size_t here = 0;
      const fcl::Vector3<S> margin = fcl::Vector3<S>::Constant(reach);
      for (const ObjectId id : candidates(fcl::AABB<S>(from.min_ - margin, from.max_ + margin))) {
        Object* const object = object_at(id.index());
        if (object == nullptr) continue;
        ++here;
        const S apart = from.distance(object->getAABB());
        if (apart >= begin && is_due(id.index())) near.push_back({apart, id.index(), object});
      }
      return here == count;
    };
    return offer_nearest_first(first_reach(from), least, list_near, [&](const NearMember<S>& near) {
      return object_at(near.place) == near.object && offer(near.object);
    });
  }

 private:
  /// How far from a box it looks first for what is near.
  [[nodiscard]] S first_reach(const fcl::AABB<S>& from) const {
    const S size = from.width() + from.height() + from.depth();
    if (!(size >= 0)) return std::numeric_limits<S>::infinity();  // NaN: at everything
    const Box<3> box = to_box(from);
    const auto nearest = static_cast<S>(index->reach_of_nearest((box.min + box.max) * 0.5F));
    const S reach = nearest < std::numeric_limits<S>::max() ? nearest + size / 1024 : size;
    return reach == 0 ? 1 : reach;
  }
};

}  // namespace kerf
