#pragma once

#include <box2d/b2_body.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_world.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <unordered_set>

#include "sims2d/box2d/box2d_contacts.h"

namespace kerf {

/// Knows which adopted fixtures (Box2dContacts) are still there: Box2D does not report which it destroys.
/// It looks at no fixture or body that may be gone, only for it in the lists of the world.
///
/// Box2D puts new bodies in front. So behind the first body that has an adopted fixture, all are older than
/// the last adoption: until the next one, bodies only leave that part, and while it has as many, it has the
/// same. Threads: `update` may run at the same time, all else alone.
class LivingBodies {
 public:
  explicit LivingBodies(const b2World& world) : world_(world) {}

  /// Call it before fixtures are adopted, and `reset` when all are.
  void forget() { count_ = kUnknown; }
  void reset() { count_ = count_of_old(); }

  /// Calls `drop(is_there)` if bodies went since the last call: `is_there(body)` looks only at the address.
  template <class Drop>
  void update(const Drop& drop) {
    const std::scoped_lock lock(mutex_);
    const std::int32_t count = count_of_old();
    if (count == count_) return;
    std::unordered_set<const b2Body*> bodies;
    for (const b2Body* body = world_.GetBodyList(); body != nullptr; body = body->GetNext())
      bodies.insert(body);
    drop([&bodies](const b2Body* body) { return bodies.contains(body); });
    count_ = count;
  }

 private:
  static constexpr std::int32_t kUnknown = -1;

  static bool has_adopted(const b2Body& body) {
    if (!body.IsEnabled()) return false;
    for (const b2Fixture* fixture = body.GetFixtureList(); fixture != nullptr; fixture = fixture->GetNext())
      if (!Box2dContacts::is_new(*fixture)) return true;
    return false;
  }
  [[nodiscard]] std::int32_t count_of_old() const {
    std::int32_t count = world_.GetBodyCount();
    const b2Body* body = world_.GetBodyList();
    for (; body != nullptr && !has_adopted(*body); body = body->GetNext()) --count;
    return count;
  }

  const b2World& world_;
  std::int32_t count_ = kUnknown;
  std::mutex mutex_;
};

/// For one query: whether a body that is there still has a fixture, and Box2D's queries would report it.
class LivingFixtures {
 public:
  bool contains(const b2Body& body, const b2Fixture* fixture) {
    if (!body.IsEnabled()) return false;
    if (looks_ > kLooksToList) return is_listed(body, fixture);
    for (const b2Fixture* one = body.GetFixtureList(); one != nullptr; one = one->GetNext(), ++looks_)
      if (one == fixture) return !Box2dContacts::is_new(*one);
    return false;
  }

 private:
  static constexpr std::size_t kLooksToList = 4096;  ///< of many fixtures a set is made, for a query of many

  bool is_listed(const b2Body& body, const b2Fixture* fixture) {
    if (bodies_.insert(&body).second)
      for (const b2Fixture* one = body.GetFixtureList(); one != nullptr; one = one->GetNext())
        if (!Box2dContacts::is_new(*one)) fixtures_.insert(one);
    return fixtures_.contains(fixture);
  }

  std::size_t looks_ = 0;
  std::unordered_set<const b2Body*> bodies_;
  std::unordered_set<const b2Fixture*> fixtures_;
};

}  // namespace kerf
