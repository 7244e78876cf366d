#pragma once

#include <fcl/broadphase/broadphase_collision_manager.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <unordered_map>
#include <vector>

#include "core/world/move_list.h"
#include "core/world/next_place.h"
#include "core/world/world.h"
#include "sims3d/fcl/fcl_box.h"
#include "sims3d/fcl/fcl_members.h"

namespace kerf {

/// A broad-phase manager of FCL, in place of fcl::DynamicAABBTreeCollisionManager.
///
/// Callbacks are called for the pairs whose boxes (CollisionObject::getAABB) overlap as closed intervals, or
/// are nearer than what `distance` has found so far: as fcl::NaiveCollisionManager does it, and for `collide`
/// with one object, for which that one calls back with all, fcl::DynamicAABBTreeCollisionManager. As with
/// FCL's managers, call `computeAABB` of an object that moved, then `update`: after it, `collide` and
/// `distance` may run at the same time. Unregister objects before they end; a callback may do so, too, and is
/// not called for what is gone. Pairs come from the tree; what meets one object, or is near it, comes from an
/// index beside it.
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
      make_room_for_next(world_, members_.list);
      const Box<3> box = to_box(object->getAABB());
      const Handle handle = insert_or_throw(world_, box);
      members_.list[handle.index()] = {object, handle, box};
      members_.index->note({handle.index()});
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
    members_.list[found->second.index()] = {};
    handles_.erase(found);
    stale_ = true;
  }
  void setup() override { update(); }
  /// Takes the present boxes of all objects and finds the pairs.
  void update() override {
    for (Member& member : members_.list)
      if (member.object != nullptr) follow(member);
    find_pairs();
  }
  void update(Object* object) override { update(std::vector<Object*>{object}); }
  void update(const std::vector<Object*>& objects) override {
    for (const Object* object : objects)
      if (const auto found = handles_.find(object); found != handles_.end())
        follow(members_.list[found->second.index()]);
    find_pairs();
  }
  void clear() override {
    for (const auto& [object, handle] : handles_) static_cast<void>(world_.remove(handle));
    members_.list.clear();
    handles_.clear();
    members_.index->forget();
    stale_ = true;
  }
  void getObjects(std::vector<Object*>& objects) const override {
    objects.clear();
    for (const Member& member : members_.list)
      if (member.object != nullptr) objects.push_back(member.object);
  }
  [[nodiscard]] bool empty() const override { return handles_.empty(); }
  [[nodiscard]] std::size_t size() const override { return handles_.size(); }

  void collide(void* data, fcl::CollisionCallBack<S> callback) const override {
    find_pairs();
    for_each_overlap([&](Object* a, Object* b) { return callback(a, b, data); });
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
    if (for_each_overlap([&](Object* a, Object* b) { return callback(a, b, data, least) || !(least > 0); }))
      return;
    for (std::size_t k = 0; k < members_.list.size(); ++k) {
      Object* const object = members_.list[k].object;
      if (object == nullptr) continue;
      const fcl::AABB<S> box = object->getAABB();
      const auto is_due = [&](std::size_t other) {
        return other < k && !members_.list[other].object->getAABB().overlap(box);
      };
      const auto offer = [&](Object* other) {
        return members_.object_at(k) == object && callback(other, object, data, least);
      };
      if (members_.offer_nearest(box, size(), least, is_due, offer)) return;
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
  using Member = typename FclMembers<S>::Member;

  void follow(Member& member) {
    const Box<3> box = to_box(member.object->getAABB());
    if (box == member.box) return;
    stale_ = true;  // first: memory may end
    moves_.add(member.handle, box);
    members_.index->note({member.handle.index()});
    member.box = box;
  }
  void find_pairs() const {
    if (!stale_) return;  // and changes nothing
    static_cast<void>(moves_.send(world_));
    world_.step();
    stale_ = false;
  }
  /// Calls `visit(a, b)` for pairs whose boxes overlap, until it returns true. Returns whether it did.
  template <class Visit>
  bool for_each_overlap(const Visit& visit) const {
    return std::ranges::any_of(world_.pairs(), [&](const WorldPair& pair) {
      Object* const a = members_.object_of(pair.a);
      Object* const b = members_.object_of(pair.b);
      return a != nullptr && b != nullptr && a->getAABB().overlap(b->getAABB()) && visit(a, b);
    });
  }
  /// `ours_first`: the order of a callback for two managers, as FCL's trees have it.
  bool collide_one(Object* object, void* data, fcl::CollisionCallBack<S> callback, bool ours_first) const {
    const std::vector<ObjectId> near = members_.candidates(object->getAABB());
    return std::ranges::any_of(near, [&](ObjectId id) {
      Object* const ours = members_.object_at(id.index());
      return ours != nullptr && object->getAABB().overlap(ours->getAABB()) &&
             (ours_first ? callback(ours, object, data) : callback(object, ours, data));
    });
  }
  bool distance_of_one(Object* object, void* data, fcl::DistanceCallBack<S> callback, bool ours_first,
                       S& least) const {
    const auto offer = [&](Object* ours) {
      return ours_first ? callback(ours, object, data, least) : callback(object, ours, data, least);
    };
    return members_.offer_nearest(
        object->getAABB(), size(), least, [](std::size_t) { return true; }, offer);
  }

  mutable World<3> world_;  ///< `collide` and `distance` are const, and what came or went waits for them
  mutable bool stale_ = false;
  FclMembers<S> members_;
  std::unordered_map<const Object*, Handle> handles_;
  mutable MoveList<3> moves_;  ///< for `find_pairs`
};

}  // namespace kerf
