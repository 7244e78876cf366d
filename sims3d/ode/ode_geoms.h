#pragma once

#include <ode/collision.h>
#include <ode/collision_space.h>
#include <ode/objects.h>

#include <array>
#include <cstddef>
#include <stdexcept>
#include <unordered_map>
#include <vector>

#include "core/world/move_list.h"
#include "core/world/next_place.h"
#include "core/world/world.h"
#include "sims3d/ode/geom_box.h"

namespace kerf {

/// Geoms of ODE and a broad phase for them, in place of a space: `collide` is dSpaceCollide.
///
/// The geoms are in no space of ODE's (dCreateSphere(nullptr, ...)), and stay the caller's: remove a geom
/// before it is destroyed. The callback is called for pairs of enabled geoms of some size whose boxes
/// overlap, which are not of one body, and of which one's category bits meet the other's collide bits: ODE's
/// rules. It must not add or remove geoms, nor call `collide` again. All calls into ODE are made by the
/// caller's thread.
class OdeGeoms {
 public:
  /// Throws std::invalid_argument for options that World refuses.
  explicit OdeGeoms(const WorldOptions& options = {}) : world_(options) {}

  /// Two geoms that are both `fixed` never form a pair; any other two may. ODE has no such rule: leave the
  /// kind out where a trigger without a body must notice walls. Throws std::invalid_argument for a geom that
  /// is here already, or whose box is NaN.
  void add(dGeomID geom, ObjectKind kind = ObjectKind::moving) {
    const auto insert = [&] {
      make_room_for_next(world_, members_);
      const Box<3> box = outward_box(geom);
      ObjectDef def;
      def.kind = kind;
      const Handle handle = insert_or_throw(world_, box, def);
      members_[handle.index()] = {geom, handle, box};
      return handle;
    };
    if (!add_under_key(handles_, geom, insert)) throw std::invalid_argument("the geom is here already");
  }
  /// A geom that is not here changes nothing.
  void remove(dGeomID geom) {
    const auto found = handles_.find(geom);
    if (found == handles_.end()) return;
    static_cast<void>(world_.remove(found->second));
    members_[found->second.index()] = {};
    handles_.erase(found);
  }
  [[nodiscard]] bool contains(dGeomID geom) const { return handles_.contains(geom); }
  [[nodiscard]] std::size_t size() const { return handles_.size(); }

  /// Calls `callback(data, a, b)` for each pair, in an order that depends only on the order in which geoms
  /// came and went, as dSpaceCollide(space, data, callback) does in another.
  void collide(void* data, dNearCallback* callback) {
    update();
    for (const WorldPair& pair : world_.pairs()) {
      const dGeomID a = members_[pair.a.index()].geom;
      const dGeomID b = members_[pair.b.index()].geom;
      if (takes_part(a) && takes_part(b) && may_touch(a, b) && boxes_touch(a, b)) callback(data, a, b);
    }
  }
  /// Calls `callback(data, geom, other)` for each geom here that forms a pair with one that is not, as
  /// dSpaceCollide2(geom, space, data, callback) does: `geom` itself may be disabled or without size. Of a
  /// geom that is a space, each geom in it is asked for that is neither. Looks at the box of each.
  void collide_with(dGeomID geom, void* data, dNearCallback* callback) const {
    if (dGeomIsSpace(geom) == 0) return collide_one(geom, data, callback);
    const auto space = reinterpret_cast<dSpaceID>(geom);
    for (int i = 0; i < dSpaceGetNumGeoms(space); ++i)
      if (const dGeomID one = dSpaceGetGeom(space, i); takes_part(one)) collide_one(one, data, callback);
  }

  /// What stands behind it: the tree, statistics, threads.
  [[nodiscard]] World<3>& world() { return world_; }

 private:
  struct Member {
    dGeomID geom = nullptr;
    Handle handle;
    Box<3> box;
  };

  void collide_one(dGeomID geom, void* data, dNearCallback* callback) const {
    for (const Member& member : members_)
      if (member.geom != nullptr && member.geom != geom && takes_part(member.geom) &&
          may_touch(geom, member.geom) && boxes_touch(geom, member.geom))
        callback(data, geom, member.geom);
  }

  /// As a space has it: neither a disabled geom is in a pair, nor one that is without size.
  static bool takes_part(dGeomID geom) { return dGeomIsEnabled(geom) != 0 && has_size(geom); }

  /// ODE keeps it as a flag that it does not show. A capsule without length is a sphere.
  static bool has_size(dGeomID geom) {
    dReal radius = 1;
    dReal length = 1;
    dReal length_of_capsule = 0;
    dVector3 sides = {1, 1, 1};
    switch (dGeomGetClass(geom)) {
      case dSphereClass:
        radius = dGeomSphereGetRadius(geom);
        break;
      case dBoxClass:
        dGeomBoxGetLengths(geom, sides);
        break;
      case dCylinderClass:
        dGeomCylinderGetParams(geom, &radius, &length);
        break;
      case dCapsuleClass:
        dGeomCapsuleGetParams(geom, &radius, &length_of_capsule);
        break;
      default:
        break;
    }
    return radius != 0 && length != 0 && sides[0] != 0 && sides[1] != 0 && sides[2] != 0;
  }

  static bool may_touch(dGeomID a, dGeomID b) {
    const dBodyID body = dGeomGetBody(a);
    if (body != nullptr && body == dGeomGetBody(b)) return false;
    return (dGeomGetCategoryBits(a) & dGeomGetCollideBits(b)) != 0 ||
           (dGeomGetCategoryBits(b) & dGeomGetCollideBits(a)) != 0;
  }

  /// As a space compares them, in ODE's numbers: the tree's boxes are rounded outward.
  static bool boxes_touch(dGeomID a, dGeomID b) {
    std::array<dReal, 6> first{};
    std::array<dReal, 6> second{};
    dGeomGetAABB(a, first.data());
    dGeomGetAABB(b, second.data());
    for (std::size_t low = 0; low < 6; low += 2)
      if (first[low] > second[low + 1] || second[low] > first[low + 1]) return false;
    return true;
  }

  void update() {
    for (Member& member : members_) {
      if (member.geom == nullptr) continue;
      const Box<3> box = outward_box(member.geom);
      if (box == member.box) continue;
      moves_.add(member.handle, box);
      member.box = box;
    }
    static_cast<void>(moves_.send(world_));
    world_.step();
  }

  World<3> world_;
  std::vector<Member> members_;  ///< by index of the handle; without a geom: free
  std::unordered_map<dGeomID, Handle> handles_;
  MoveList<3> moves_;
};

}  // namespace kerf
