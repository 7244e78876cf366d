#include "sims2d/contact_gate.h"

#include <box2d/b2_body.h>
#include <box2d/b2_contact.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_world.h>

#include <algorithm>

#include "sims2d/contact_pair.h"
#include "sims2d/convert.h"

namespace kerf::inline sims2d {
namespace {

/// AddPair takes proxies, which a fixture shows only to derived classes.
struct ProxyOf : b2Fixture {
  static b2FixtureProxy& of(b2Body& body) { return *(*body.GetFixtureList().*(&ProxyOf::m_proxies)); }
};

b2AABB bounds_of(b2Body& body) {
  const Box<2> box = padded_box(*body.GetFixtureList()->GetShape(), body.GetTransform());
  b2AABB bounds;
  bounds.lowerBound.Set(box.min[0], box.min[1]);
  bounds.upperBound.Set(box.max[0], box.max[1]);
  return bounds;
}

/// Box2D destroys a contact whose proxies' fat boxes do not overlap. They hold the tight boxes, but perhaps
/// not the padded ones, by which a pair may exist; then they are renewed.
void make_room(b2BroadPhase& proxies, b2Body& a, b2Body& b) {
  const int32 proxy_a = ProxyOf::of(a).proxyId;
  const int32 proxy_b = ProxyOf::of(b).proxyId;
  if (proxies.TestOverlap(proxy_a, proxy_b)) return;
  proxies.MoveProxy(proxy_a, bounds_of(a), b2Vec2_zero);
  proxies.MoveProxy(proxy_b, bounds_of(b), b2Vec2_zero);
}

}  // namespace

// Box2D returns its contact manager as const only; the world itself is ours to change.
ContactGate::ContactGate(b2World& world)
    : world_(world), manager_(const_cast<b2ContactManager&>(world.GetContactManager())) {
  world.SetContactFilter(this);
}

bool ContactGate::ShouldCollide(b2Fixture* /*a*/, b2Fixture* /*b*/) { return open_; }

void ContactGate::list_standing() {
  standing_.clear();
  for (b2Contact* contact = world_.GetContactList(); contact != nullptr; contact = contact->GetNext())
    standing_.push_back({pair_of(*contact), contact});
  std::sort(standing_.begin(), standing_.end(),
            [](const Standing& x, const Standing& y) { return x.pair < y.pair; });
}

void ContactGate::admit(std::span<const Pair> pairs, std::span<b2Body* const> bodies) {
  list_standing();
  auto old = standing_.begin();
  for (const Pair& pair : pairs) {
    for (; old != standing_.end() && old->pair < pair; ++old) manager_.Destroy(old->contact);
    b2Body& a = *bodies[pair.a.index()];
    b2Body& b = *bodies[pair.b.index()];
    make_room(manager_.m_broadPhase, a, b);
    if (old != standing_.end() && old->pair == pair) {
      ++old;
      continue;
    }
    open_ = true;
    manager_.AddPair(&ProxyOf::of(a), &ProxyOf::of(b));
    open_ = false;
  }
  for (; old != standing_.end(); ++old) manager_.Destroy(old->contact);
}

}  // namespace kerf::inline sims2d
