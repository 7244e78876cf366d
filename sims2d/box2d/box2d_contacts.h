#pragma once

#include <box2d/b2_body.h>
#include <box2d/b2_contact.h>
#include <box2d/b2_contact_manager.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_shape.h>
#include <box2d/b2_world.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/base/ids.h"

namespace kerf {

/// Makes the contacts of a Box2D world those of a given list of pairs, and no others.
///
/// Box2D 2.4 has no switch for another broad phase, so its own is left without work: each fixture is taken
/// out of Box2D's tree and never put back, and contacts are created by a call of what Box2D's broad phase
/// would call. Filters, joints and listeners work as ever. What asks Box2D's tree finds nothing, that is,
/// b2World::QueryAABB, b2World::RayCast and b2Fixture::GetAABB.
///
/// One child of a fixture is one object. The world must outlive this and must not be stepped after it.
class Box2dContacts {
 public:
  explicit Box2dContacts(b2World& world)
      : world_(world),
        // Box2D returns its contact manager as const only; the world itself is the caller's to change.
        manager_(const_cast<b2ContactManager&>(world.GetContactManager())) {
    b2AABB nowhere;
    nowhere.lowerBound.Set(kFar, kFar);
    nowhere.upperBound = nowhere.lowerBound;
    shared_proxy_ = manager_.m_broadPhase.CreateProxy(nowhere, nullptr);
  }
  Box2dContacts(const Box2dContacts&) = delete;
  Box2dContacts& operator=(const Box2dContacts&) = delete;
  ~Box2dContacts() = default;

  /// Whether Box2D's own tree has the fixture. A new fixture is there, also one at the address of another
  /// that was destroyed, and those of a body that was enabled.
  [[nodiscard]] static bool is_new(const b2Fixture& fixture) { return Access::count(fixture) > 0; }

  /// Takes a new fixture out of Box2D's tree. `children` has the object of each child.
  void adopt(b2Fixture& fixture, std::span<const ObjectId> children) {
    objects_[&fixture].assign(children.begin(), children.end());
    for (const ObjectId child : children)
      if (proxies_.size() <= child.index()) proxies_.resize(child.index() + 1);
    for (std::size_t child = 0; child < children.size(); ++child) {  // memory cannot end any more
      b2FixtureProxy& proxy = Access::proxies(fixture)[child];
      manager_.m_broadPhase.DestroyProxy(proxy.proxyId);
      proxy.proxyId = shared_proxy_;
      proxies_[children[child].index()] = &proxy;
    }
    Access::count(fixture) = 0;
    changed_ = true;
  }

  /// The fixture is gone, or stands for no object any more. It is not looked at.
  void forget(const b2Fixture& fixture) {
    objects_.erase(&fixture);
    changed_ = true;
  }

  /// Destroys contacts without a pair, and creates one for each pair without a contact that Box2D's filters
  /// allow. `pairs` are of adopted fixtures' objects and ascending: the order of creation decides the order
  /// in which the solver works. Call it before each b2World::Step.
  void admit(std::span<const Pair> pairs) {
    if (changed_ || static_cast<std::size_t>(manager_.m_contactCount) != standing_.size()) list_standing();
    changed_ = true;  // until all is done: memory may end before
    kept_.clear();
    auto old = standing_.begin();
    for (const Pair& pair : pairs) {
      for (; old != standing_.end() && old->pair < pair; ++old) manager_.Destroy(old->contact);
      if (old != standing_.end() && old->pair == pair) {
        kept_.push_back(*old++);
      } else {
        create(pair);
      }
    }
    for (; old != standing_.end(); ++old) manager_.Destroy(old->contact);
    standing_.swap(kept_);
    changed_ = false;
  }

 private:
  struct Standing {
    Pair pair;
    b2Contact* contact;
  };

  /// A fixture shows its proxies only to derived classes.
  struct Access : b2Fixture {
    static b2FixtureProxy* proxies(b2Fixture& fixture) { return fixture.*(&Access::m_proxies); }
    static std::int32_t& count(b2Fixture& fixture) { return fixture.*(&Access::m_proxyCount); }
    static std::int32_t count(const b2Fixture& fixture) { return fixture.*(&Access::m_proxyCount); }
  };

  static constexpr float kFar = 1e18F;  ///< no fixture comes here

  [[nodiscard]] ObjectId object_of(const b2Fixture* fixture, std::int32_t child) const {
    return objects_.at(fixture)[static_cast<std::size_t>(child)];
  }

  void create(const Pair& pair) {
    const std::int32_t before = manager_.m_contactCount;
    manager_.AddPair(proxies_[pair.a.index()], proxies_[pair.b.index()]);
    if (manager_.m_contactCount != before) kept_.push_back({pair, manager_.m_contactList});
  }

  /// Of adopted fixtures only `admit` creates contacts, so that a list of their number holds them all; others
  /// destroy some. A fixture that was created after the last `admit` has those that Box2D's step found.
  void list_standing() {
    standing_.clear();
    for (b2Contact* contact = world_.GetContactList(); contact != nullptr; contact = contact->GetNext()) {
      const ObjectId a = object_of(contact->GetFixtureA(), contact->GetChildIndexA());
      const ObjectId b = object_of(contact->GetFixtureB(), contact->GetChildIndexB());
      standing_.push_back({make_pair(a, b), contact});
    }
    std::ranges::sort(standing_, {}, &Standing::pair);
  }

  b2World& world_;
  b2ContactManager& manager_;
  std::int32_t shared_proxy_;  ///< of all fixtures: Box2D destroys contacts of proxies that do not overlap
  std::unordered_map<const b2Fixture*, std::vector<ObjectId>> objects_;  ///< of each fixture's children
  std::vector<b2FixtureProxy*> proxies_;                                 ///< by object
  std::vector<Standing> standing_;  ///< by pair: all contacts of the world
  std::vector<Standing> kept_;
  bool changed_ = false;  ///< fixtures came or went since the last `admit`
};

}  // namespace kerf
