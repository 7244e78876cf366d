#pragma once

#include <fcl/broadphase/broadphase_collision_manager.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <unordered_map>
#include <vector>

#include "core/spatial/lazy_index.h"
#include "core/world/move_list.h"
#include "core/world/next_place.h"
#include "core/world/world.h"
#include "sims3d/fcl/fcl_box.h"

namespace kerf {

/// A broad-phase manager of FCL, in place of fcl::DynamicAABBTreeCollisionManager.
///
/// Callbacks are called for the pairs whose boxes (CollisionObject::getAABB) overlap as closed intervals, or
/// are nearer than what `distance` has found so far: as fcl::NaiveCollisionManager does it, and for `collide`
/// with one object, for which that one calls back with all, fcl::DynamicAABBTreeCollisionManager. As with
/// FCL's managers, call `computeAABB` of an object that moved, then `update`: after it, `collide` and
/// `distance` may run at the same time. Unregister objects before they end. Pairs come from the tree; what
/// meets one object comes from an index beside it, and `distance` to one looks at the box of each.
template <typename S>
class FclManager final : public fcl::BroadPhaseCollisionManager<S> {
 public:
  using Object = fcl::CollisionObject<S>;
  using Manager = fcl::BroadPhaseCollisionManager<S>;

  /// Throws std::invalid_argument for options that World refuses.
  explicit FclManager(const WorldOptions& options = {}) : world_(options) {}

  [[nodiscard]] World<3>& world() { return world_; }

  using Manager::update;

  /// Throws std::invalid_argument for an object that is here already, or whose box is NaN.
  void registerObject(Object* object) override {
    const auto insert = [&] {
      make_room_for_next(world_, members_);
      const Box<3> box = to_box(object->getAABB());
      const Handle handle = insert_or_throw(world_, box);
      members_[handle.index()] = {object, handle, box};
      index_->note({handle.index()});
      return handle;
    };
    if (!add_under_key(handles_, object, insert))
      throw std::invalid_argument("the object is registered already");
    stale_ = true;
  }
  /// An object that is not here changes nothing.
  void unregisterObject(Object* object) override {
    const auto found = handles_.find(object);
    if (found == handles_.end()) return;
    static_cast<void>(world_.remove(found->second));
    members_[found->second.index()] = {};
    handles_.erase(found);
    stale_ = true;
  }
  void setup() override { update(); }
  /// Takes the present boxes of all objects and finds the pairs.
  void update() override {
    for (Member& member : members_)
      if (member.object != nullptr) follow(member);
    find_pairs();
  }
  void update(Object* object) override { update(std::vector<Object*>{object}); }
  void update(const std::vector<Object*>& objects) override {
    for (const Object* object : objects)
      if (const auto found = handles_.find(object); found != handles_.end())
        follow(members_[found->second.index()]);
    find_pairs();
  }
  void clear() override {
    for (const auto& [object, handle] : handles_) static_cast<void>(world_.remove(handle));
    members_.clear();
    handles_.clear();
    index_->forget();
    stale_ = true;
  }
  void getObjects(std::vector<Object*>& objects) const override {
    objects.clear();
    for (const Member& member : members_)
      if (member.object != nullptr) objects.push_back(member.object);
  }
  [[nodiscard]] bool empty() const override { return handles_.empty(); }
  [[nodiscard]] std::size_t size() const override { return handles_.size(); }

  void collide(void* data, fcl::CollisionCallBack<S> callback) const override {
    find_pairs();
    for (const WorldPair& pair : world_.pairs()) {
      Object* const a = members_[pair.a.index()].object;
      Object* const b = members_[pair.b.index()].object;
      if (a->getAABB().overlap(b->getAABB()) && callback(a, b, data)) return;
    }
  }
  void collide(Object* object, void* data, fcl::CollisionCallBack<S> callback) const override {
    collide_one(object, data, callback, false);
  }
  void collide(Manager* other, void* data, fcl::CollisionCallBack<S> callback) const override {
    if (other == this) return collide(data, callback);
    for (Object* object : objects_of(*other))
      if (collide_one(object, data, callback, true)) return;
  }

  /// First looks at overlapping boxes, then for what is near each object among those before it.
  void distance(void* data, fcl::DistanceCallBack<S> callback) const override {
    find_pairs();
    S least = std::numeric_limits<S>::max();
    for (const WorldPair& pair : world_.pairs()) {
      Object* const a = members_[pair.a.index()].object;
      Object* const b = members_[pair.b.index()].object;
      if ((a->getAABB().overlap(b->getAABB()) && callback(a, b, data, least)) || !(least > 0)) return;
    }
    for (const Member& member : members_) {
      if (member.object == nullptr) continue;
      const auto is_due = [&](const Member& other) {
        return &other < &member && !other.object->getAABB().overlap(member.object->getAABB());
      };
      const auto offer = [&](Object* other) { return callback(other, member.object, data, least); };
      if (offer_nearest(member.object->getAABB(), least, is_due, offer)) return;
    }
  }
  void distance(Object* object, void* data, fcl::DistanceCallBack<S> callback) const override {
    S least = std::numeric_limits<S>::max();
    distance_of_one(object, data, callback, false, least);
  }
  void distance(Manager* other, void* data, fcl::DistanceCallBack<S> callback) const override {
    if (other == this) return distance(data, callback);
    S least = std::numeric_limits<S>::max();
    for (Object* object : objects_of(*other))
      if (distance_of_one(object, data, callback, true, least)) return;
  }

 private:
  struct Member {
    Object* object = nullptr;
    Handle handle;
    Box<3> box;
  };
  struct Near {
    S apart;
    Object* object;
  };

  void follow(Member& member) {
    const Box<3> box = to_box(member.object->getAABB());
    if (box == member.box) return;
    stale_ = true;  // first: memory may end
    moves_.add(member.handle, box);
    index_->note({member.handle.index()});
    member.box = box;
  }
  void find_pairs() const {
    if (!stale_) return;  // and changes nothing
    static_cast<void>(moves_.send(world_));
    world_.step();
    stale_ = false;
  }
  /// `ours_first`: the order of a callback for two managers, as FCL's trees have it.
  bool collide_one(Object* object, void* data, fcl::CollisionCallBack<S> callback, bool ours_first) const {
    const std::vector<ObjectId> near = candidates(object->getAABB());
    return std::ranges::any_of(near, [&](ObjectId id) {
      Object* const ours = id.index() < members_.size() ? members_[id.index()].object : nullptr;
      return ours != nullptr && object->getAABB().overlap(ours->getAABB()) &&
             (ours_first ? callback(ours, object, data) : callback(object, ours, data));
    });
  }
  bool distance_of_one(Object* object, void* data, fcl::DistanceCallBack<S> callback, bool ours_first,
                       S& least) const {
    const auto is_due = [](const Member&) { return true; };
    const auto offer = [&](Object* ours) {
      return ours_first ? callback(ours, object, data, least) : callback(object, ours, data, least);
    };
    return offer_nearest(object->getAABB(), least, is_due, offer);
  }
  /// Offers what is due and nearer than `least`, the nearest boxes first, so that few others are nearer than
  /// what their objects are apart. Nothing says how far the nearest is: it looks into a box that grows.
  template <class IsDue, class Offer>
  bool offer_nearest(const fcl::AABB<S>& from, const S& least, const IsDue& is_due,
                     const Offer& offer) const {
    constexpr S kGrowth = 4;
    S offered = -1;  // all that is nearer
    S reach = std::max({from.width(), from.height(), from.depth()});
    if (!(reach >= 0)) return false;  // NaN is near nothing
    if (reach == 0) reach = 1;
    for (std::vector<Near> near;; offered = reach, reach *= kGrowth) {
      reach = std::min(reach, least);
      const bool are_all = list_near(from, reach, is_due, near);
      std::ranges::sort(near, {}, &Near::apart);
      for (const Near& one : near) {
        if (one.apart < offered) continue;
        if (one.apart >= (are_all ? least : std::min(reach, least))) break;
        if (offer(one.object)) return true;
      }
      if (are_all || !(reach < least)) return false;
    }
  }
  /// Everything that is due and nearer than `reach`, and more. Returns whether nothing is missing.
  template <class IsDue>
  bool list_near(const fcl::AABB<S>& from, S reach, const IsDue& is_due, std::vector<Near>& near) const {
    near.clear();
    std::size_t here = 0;
    const fcl::Vector3<S> margin = fcl::Vector3<S>::Constant(reach);
    for (const ObjectId id : candidates(fcl::AABB<S>(from.min_ - margin, from.max_ + margin))) {
      if (id.index() >= members_.size() || members_[id.index()].object == nullptr) continue;
      ++here;
      const Member& member = members_[id.index()];
      const S apart = from.distance(member.object->getAABB());
      if (apart >= 0 && is_due(member)) near.push_back({apart, member.object});
    }
    return here == handles_.size();
  }
  /// What may overlap a box, each once, and others, some of which may be gone.
  std::vector<ObjectId> candidates(const fcl::AABB<S>& box) const {
    const auto box_of = [this](ObjectId id) {
      const Member& member = members_[id.index()];
      return member.object != nullptr ? std::optional(member.box) : std::nullopt;
    };
    return index_->candidates(to_box(box), members_.size(), box_of);
  }

  mutable World<3> world_;  ///< `collide` and `distance` are const, and what came or went waits for them
  mutable bool stale_ = false;
  std::vector<Member> members_;  ///< by index of the handle; without an object: free
  std::unordered_map<const Object*, Handle> handles_;
  std::unique_ptr<LazyIndex<3>> index_ = std::make_unique<LazyIndex<3>>();
  mutable MoveList<3> moves_;  ///< for `find_pairs`
};

}  // namespace kerf
