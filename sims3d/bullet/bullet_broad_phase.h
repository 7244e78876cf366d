#pragma once

#include <BulletCollision/BroadphaseCollision/btBroadphaseInterface.h>
#include <BulletCollision/BroadphaseCollision/btOverlappingPairCache.h>
#include <LinearMath/btAabbUtil2.h>

#include <array>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/spatial/lazy_index.h"
#include "core/world/move_list.h"
#include "core/world/next_place.h"
#include "core/world/world.h"
#include "sims3d/bullet/bullet_box.h"
#include "sims3d/bullet/bullet_proxy.h"

namespace kerf {

/// The broad phase of a Bullet world, in place of btDbvtBroadphase.
///
/// Pairs are exact: the boxes that Bullet gives overlap as closed intervals. They are brought up to date by
/// calculateOverlappingPairs, which a world calls in each step, and are in the pair cache like those of
/// Bullet's own: filters, ghost objects and the dispatcher work as ever. The cache gets only the pairs that
/// begin or end: a pair that something else takes out of it comes again when it begins again; after a change
/// of a filter call btCollisionWorld::refreshBroadphaseProxy, as with Bullet's own.
///
/// Proxies of which each is in the group StaticFilter alone and masks that group out never form a pair,
/// whatever an overlap filter says. A box with NaN, or with min > max, leaves the proxy where it was; one
/// that is made with such a box is in no pair, and found by no query, until it gets another.
///
/// rayTest and aabbTest see the boxes that were given last, and call back in no particular order. They may
/// run at the same time, as with Bullet's own.
class BulletBroadPhase final : public btBroadphaseInterface {
 public:
  /// `cache` must outlive this and remove pairs at once; without one a btHashedOverlappingPairCache is made.
  /// Throws std::invalid_argument for a cache that defers removals, and for options that World refuses.
  explicit BulletBroadPhase(const WorldOptions& options = {}, btOverlappingPairCache* cache = nullptr)
      : options_(options), world_(std::make_unique<World<3>>(options)), cache_(cache) {
    if (cache_ == nullptr) {
      own_cache_ = std::make_unique<btHashedOverlappingPairCache>();
      cache_ = own_cache_.get();
    }
    if (cache_->hasDeferredRemoval())
      throw std::invalid_argument(
          "the pair cache must remove pairs at once: use btHashedOverlappingPairCache");
  }

  /// Null if there are as many proxies as World takes.
  btBroadphaseProxy* createProxy(const btVector3& min, const btVector3& max, int /*shape_type*/, void* user,
                                 int group, int mask, btDispatcher* /*dispatcher*/) override {
    auto made = std::make_unique<BulletProxy>(min, max, user, group, mask);
    BulletProxy* const proxy = made.get();
    const WorldStatus status = place(made);
    if (status == WorldStatus::full) return nullptr;
    if (is_failure(status)) boxless_.push_back(std::move(made));
    proxy->m_uniqueId = ++last_id_;
    return proxy;
  }

  void destroyProxy(btBroadphaseProxy* proxy, btDispatcher* dispatcher) override {
    cache_->removeOverlappingPairsContainingProxy(proxy, dispatcher);
    const Handle handle = static_cast<BulletProxy*>(proxy)->handle;
    if (handle.is_none()) {
      boxless_.erase(find_proxy(boxless_, proxy));
      return;
    }
    static_cast<void>(world_->remove(handle));
    proxies_[handle.index()].reset();
  }

  void setAabb(btBroadphaseProxy* proxy, const btVector3& min, const btVector3& max,
               btDispatcher* /*dispatcher*/) override {
    const Handle handle = static_cast<BulletProxy*>(proxy)->handle;
    if (!handle.is_none() && proxy->m_aabbMin == min && proxy->m_aabbMax == max) return;
    const Box<3> box = to_box(min, max);
    if (!can_be_placed(box)) return;
    if (!handle.is_none()) moves_.add(handle, box);
    proxy->m_aabbMin = min;
    proxy->m_aabbMax = max;
    if (!handle.is_none()) return index_->note({handle.index()});
    const auto found = find_proxy(boxless_, proxy);
    if (!is_failure(place(*found))) boxless_.erase(found);
  }
  void getAabb(btBroadphaseProxy* proxy, btVector3& min, btVector3& max) const override {
    min = proxy->m_aabbMin;
    max = proxy->m_aabbMax;
  }

  void calculateOverlappingPairs(btDispatcher* dispatcher) override {
    static_cast<void>(moves_.send(*world_));
    world_->step();
    for (const WorldPair& pair : world_->ended())
      if (has_both(pair)) cache_->removeOverlappingPair(&proxy_of(pair.a), &proxy_of(pair.b), dispatcher);
    for (const WorldPair& pair : world_->begun())
      if (has_both(pair)) cache_->addOverlappingPair(&proxy_of(pair.a), &proxy_of(pair.b));
  }
  btOverlappingPairCache* getOverlappingPairCache() override { return cache_; }
  [[nodiscard]] const btOverlappingPairCache* getOverlappingPairCache() const override { return cache_; }

  /// As with Bullet's own, [min, max] is the box of what is cast along the ray, around the ray's point, and
  /// the way is that of the callback. Ends when the callback returns false.
  void rayTest(const btVector3& from, const btVector3& /*to*/, btBroadphaseRayCallback& callback,
               const btVector3& min, const btVector3& max) override {
    for (const ObjectId object : candidates(to_cast(from, callback, min, max))) {
      btBroadphaseProxy* const proxy = proxy_at(object);
      if (proxy == nullptr) continue;
      const std::array<btVector3, 2> bounds = {proxy->m_aabbMin - max, proxy->m_aabbMax - min};
      btScalar entry = 1;
      if (btRayAabb2(from, callback.m_rayDirectionInverse, callback.m_signs, bounds.data(), entry, 0,
                     callback.m_lambda_max) &&
          !callback.process(proxy))
        return;
    }
  }
  /// Ends when the callback returns false.
  void aabbTest(const btVector3& min, const btVector3& max, btBroadphaseAabbCallback& callback) override {
    for (const ObjectId object : candidates(to_box(min, max))) {
      btBroadphaseProxy* const proxy = proxy_at(object);
      if (proxy != nullptr && TestAabbAgainstAabb2(min, max, proxy->m_aabbMin, proxy->m_aabbMax) &&
          !callback.process(proxy))
        return;
    }
  }

  /// Two equal points at the origin without any proxy.
  void getBroadphaseAabb(btVector3& min, btVector3& max) const override {
    bool any = false;
    for (const auto& proxy : proxies_) {
      if (!proxy) continue;
      if (!any) {
        min = proxy->m_aabbMin;
        max = proxy->m_aabbMax;
      }
      any = true;
      min.setMin(proxy->m_aabbMin);
      max.setMax(proxy->m_aabbMax);
    }
    if (!any) min = max = btVector3(0, 0, 0);
  }
  /// Without any proxy all is as it was when this was made.
  void resetPool(btDispatcher* /*dispatcher*/) override {
    if (world_->size() > 0 || !boxless_.empty()) return;
    world_ = std::make_unique<World<3>>(options_);
    moves_ = {};
    proxies_.clear();
    index_->forget();
    last_id_ = 0;
  }
  void printStats() override {}

  /// What stands behind it: the tree, statistics, threads. Object k of the tree is that of handle index k.
  [[nodiscard]] World<3>& world() { return *world_; }

 private:
  /// Takes the proxy if its box can be placed.
  WorldStatus place(std::unique_ptr<BulletProxy>& proxy) {
    make_room_for_next(*world_, proxies_);
    ObjectDef def;
    def.kind = kind_of(*proxy);
    const auto [status, handle] = world_->insert(to_box(proxy->m_aabbMin, proxy->m_aabbMax), def);
    if (is_failure(status)) return status;
    proxy->handle = handle;
    proxies_[handle.index()] = std::move(proxy);
    index_->note({handle.index()});
    return status;
  }
  /// A proxy may have gone since the last step, also in a callback of the cache.
  [[nodiscard]] bool has_both(const WorldPair& pair) const {
    return world_->contains(pair.a) && world_->contains(pair.b);
  }
  [[nodiscard]] btBroadphaseProxy& proxy_of(Handle handle) const { return *proxies_[handle.index()]; }
  /// Null if there is none any more: a callback may have removed it.
  [[nodiscard]] btBroadphaseProxy* proxy_at(ObjectId object) const {
    return object.index() < proxies_.size() ? proxies_[object.index()].get() : nullptr;
  }
  template <class Query>
  std::vector<ObjectId> candidates(const Query& query) {
    return index_->candidates(query, proxies_.size(), [this](ObjectId object) -> std::optional<Box<3>> {
      const auto& proxy = proxies_[object.index()];
      return proxy ? std::optional(to_box(proxy->m_aabbMin, proxy->m_aabbMax)) : std::nullopt;
    });
  }

  WorldOptions options_;
  std::unique_ptr<World<3>> world_;
  std::unique_ptr<btOverlappingPairCache> own_cache_;
  btOverlappingPairCache* cache_;
  BulletProxies proxies_;  ///< by index of the handle
  BulletProxies boxless_;  ///< made with a box that is none
  std::unique_ptr<LazyIndex<3>> index_ = std::make_unique<LazyIndex<3>>();
  MoveList<3> moves_;
  int last_id_ = 0;
};

}  // namespace kerf
