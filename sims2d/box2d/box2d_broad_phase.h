#pragma once

#include <box2d/b2_body.h>
#include <box2d/b2_common.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_world.h>
#include <box2d/b2_world_callbacks.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "core/spatial/lazy_index.h"
#include "core/world/move_list.h"
#include "core/world/next_place.h"
#include "core/world/world.h"
#include "sims2d/box2d/box2d_contacts.h"
#include "sims2d/box2d/kind_of.h"
#include "sims2d/box2d/living_fixtures.h"
#include "sims2d/box2d/padded_box.h"
#include "sims2d/box2d/pose_after.h"

namespace kerf {

/// The broad phase of a Box2D world, in place of Box2D's own.
///
/// Call `update` before each b2World::Step, and create and change bodies, fixtures and joints as ever. Each
/// contact is a pair of padded boxes (kBoxPadding) that overlap and that Box2D's filters allow. Queries are
/// here, since Box2D's tree is empty (Box2dContacts): they report no fixture that was destroyed, or whose
/// body was disabled, since the last `update`. The world must outlive this and must not be stepped after it.
class Box2dBroadPhase {
 public:
  /// Throws std::invalid_argument for options that World refuses.
  explicit Box2dBroadPhase(b2World& world, const WorldOptions& options = {})
      : engine_(world), contacts_(world), living_(world), world_(options) {}

  /// `seconds` is the time step that follows. Where continuous physics is on, boxes reach to where the
  /// present velocities take and turn them in it, so that what hits on the way has its contact. What changes
  /// a velocity within the step is not foreseen: a bullet that a force (b2Body::ApplyForce), a joint or
  /// another body makes fast in it may pass a thin wall in that one step. An impulse before `update` is
  /// foreseen. Throws std::invalid_argument for a new fixture whose box is NaN.
  void update(float seconds) {
    ++round_;
    living_.forget();
    for (b2Body* body = engine_.GetBodyList(); body != nullptr; body = body->GetNext()) {
      if (!body->IsEnabled()) continue;
      const b2Transform ahead =
          engine_.GetContinuousPhysics() ? pose_after(*body, seconds) : body->GetTransform();
      for (b2Fixture* fixture = body->GetFixtureList(); fixture != nullptr; fixture = fixture->GetNext())
        follow(*fixture, body->GetTransform(), ahead);
    }
    drop_gone();
    living_.reset();
    static_cast<void>(moves_.send(world_));
    world_.step();
    pairs_.clear();
    for (const WorldPair& pair : world_.pairs()) pairs_.push_back({{pair.a.index()}, {pair.b.index()}});
    contacts_.admit(pairs_);
  }

  /// As b2World::QueryAABB, over the boxes of the last `update`.
  void query(b2QueryCallback& callback, const b2AABB& box) const {
    const Box<2> asked = to_box(box.lowerBound, box.upperBound);
    LivingFixtures living;
    for (const ObjectId object : candidates(asked)) {
      const Child& child = children_[object.index()];
      if (child.fixture != nullptr && overlaps(child.box, asked) &&
          living.contains(*child.body, child.fixture) && !callback.ReportFixture(child.fixture))
        return;
    }
  }
  /// As b2World::RayCast, over the boxes of the last `update`.
  void ray_cast(b2RayCastCallback& callback, const b2Vec2& from, const b2Vec2& to) const {
    b2RayCastInput input{from, to, 1};
    const SweptBox<2> line{to_box(from, from), {{to.x - from.x, to.y - from.y}}};
    LivingFixtures living;
    for (const ObjectId object : candidates(Cast<2>(with_slack(line)))) {
      const Child& child = children_[object.index()];
      const b2Vec2 end = from + input.maxFraction * (to - from);
      if (child.fixture == nullptr || !overlaps(child.box, to_box(b2Min(from, end), b2Max(from, end))) ||
          !living.contains(*child.body, child.fixture))
        continue;
      b2RayCastOutput hit;
      if (!child.fixture->RayCast(&hit, input, child.index)) continue;
      const b2Vec2 point = (1 - hit.fraction) * from + hit.fraction * to;
      const float limit = callback.ReportFixture(child.fixture, point, hit.normal, hit.fraction);
      if (limit == 0) return;
      if (limit > 0) input.maxFraction = limit;
    }
  }

  /// What stands behind it: the tree, statistics, threads.
  [[nodiscard]] World<2>& world() { return world_; }

 private:
  struct Member {
    std::vector<Handle> children;
    b2Transform transform;
    b2Transform ahead;  ///< at the end of the step
    b2BodyType type = b2_staticBody;
    std::uint64_t round = 0;  ///< of the last update that saw the fixture
  };
  struct Child {
    b2Fixture* fixture = nullptr;
    const b2Body* body = nullptr;
    std::int32_t index = 0;
    Box<2> box;
  };

  template <class Query>
  std::vector<ObjectId> candidates(const Query& query) const {
    living_.update([this](const auto& is_there) {
      for (Child& child : children_)
        if (!is_there(child.body)) child = {};
    });
    return index_->candidates(query, children_.size(), [this](ObjectId object) {
      const Child& child = children_[object.index()];
      return child.fixture != nullptr ? std::optional(child.box) : std::nullopt;
    });
  }

  static Box<2> box_of(const b2Fixture& fixture, std::int32_t child, const Member& member) {
    const Box<2> here = padded_box(*fixture.GetShape(), member.transform, child);
    return join(here, padded_box(*fixture.GetShape(), member.ahead, child));
  }
  void follow(b2Fixture& fixture, const b2Transform& transform, const b2Transform& ahead) {
    Member& member = members_[&fixture];
    member.round = round_;
    const bool same = is_same_pose(member.transform, transform) && is_same_pose(member.ahead, ahead);
    member.transform = transform;
    member.ahead = ahead;
    if (Box2dContacts::is_new(fixture)) return adopt(fixture, member);
    if (const b2BodyType type = fixture.GetBody()->GetType(); type != member.type) set_type(member, type);
    if (same && !is_refreshed(*fixture.GetBody())) return;
    for (const Handle handle : member.children) {
      Child& child = children_[handle.index()];
      const Box<2> box = box_of(fixture, child.index, member);
      if (box == child.box) continue;
      moves_.add(handle, box);
      index_->note({handle.index()});
      child.box = box;
    }
  }

  void adopt(b2Fixture& fixture, Member& member) {
    drop(member);
    member.type = fixture.GetBody()->GetType();
    ObjectDef def;
    def.kind = kind_of(member.type);
    const std::int32_t count = fixture.GetShape()->GetChildCount();
    member.children.reserve(static_cast<std::size_t>(count));
    std::vector<ObjectId> objects;
    for (std::int32_t child = 0; child < count; ++child) {
      make_room_for_next(world_, children_);
      const Box<2> box = box_of(fixture, child, member);
      const Handle handle = insert_or_throw(world_, box, def);
      member.children.push_back(handle);
      objects.push_back({handle.index()});
      children_[handle.index()] = {&fixture, fixture.GetBody(), child, box};
      index_->note({handle.index()});
    }
    contacts_.adopt(fixture, objects);
  }
  void set_type(Member& member, b2BodyType type) {
    member.type = type;
    for (const Handle handle : member.children) static_cast<void>(world_.set_kind(handle, kind_of(type)));
  }
  void drop(Member& member) {
    for (const Handle handle : member.children) {
      static_cast<void>(world_.remove(handle));
      children_[handle.index()] = {};
    }
    member.children.clear();
  }
  void drop_gone() {
    for (auto entry = members_.begin(); entry != members_.end();) {
      const auto here = entry++;
      if (here->second.round == round_) continue;
      drop(here->second);
      contacts_.forget(*here->first);
      members_.erase(here);
    }
  }

  b2World& engine_;
  Box2dContacts contacts_;
  mutable LivingBodies living_;  ///< of it and `children_` a query changes what lets go of destroyed bodies
  World<2> world_;
  std::unordered_map<const b2Fixture*, Member> members_;
  mutable std::vector<Child> children_;  ///< by index of the handle; without a fixture: free
  std::vector<Pair> pairs_;
  std::unique_ptr<LazyIndex<2>> index_ = std::make_unique<LazyIndex<2>>();
  MoveList<2> moves_;
  std::uint64_t round_ = 0;
};

}  // namespace kerf
