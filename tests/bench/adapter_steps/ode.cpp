#include <ode/ode.h>

#include <array>
#include <functional>
#include <memory>

#include "sims3d/ode/ode_geoms.h"
#include "tests/bench/adapter_steps/contest.h"

namespace kerf::adapters {
namespace {

enum class Structure { hash, sweep_and_prune, ours };

/// The dynamics of a scene; pairs come from a space or from ours.
class OdeScene {
 public:
  OdeScene(const Start& start, Structure structure) : gas_(start.gravity == 0) {
    dInitODE2(0);
    dAllocateODEDataForThread(static_cast<unsigned>(dAllocateMaskAll));
    world_ = dWorldCreate();
    joints_ = dJointGroupCreate(0);
    dWorldSetGravity(world_, 0, -start.gravity, 0);
    dWorldSetQuickStepNumIterations(world_, 10);
    if (!gas_) dWorldSetAutoDisableFlag(world_, 1);
    if (structure == Structure::hash) space_ = dHashSpaceCreate(nullptr);
    if (structure == Structure::sweep_and_prune) space_ = dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XZY);
    for (int axis = 0; axis < 3; ++axis) {
      const auto normal = [axis](int i, int sign) { return i == axis ? static_cast<dReal>(sign) : dReal{0}; };
      add(dCreatePlane(space_, normal(0, 1), normal(1, 1), normal(2, 1), 0), ObjectKind::fixed);
      if (axis == 1 && !gas_) continue;
      add(dCreatePlane(space_, normal(0, -1), normal(1, -1), normal(2, -1), -start.side), ObjectKind::fixed);
    }
    for (std::size_t k = 0; k < start.positions.size(); ++k)
      add_ball(start.positions[k], start.velocities[k]);
  }
  OdeScene(const OdeScene&) = delete;
  OdeScene& operator=(const OdeScene&) = delete;
  ~OdeScene() {
    for (const dGeomID geom : all_) dGeomDestroy(geom);
    if (space_ != nullptr) dSpaceDestroy(space_);
    dJointGroupDestroy(joints_);
    dWorldDestroy(world_);
    dCloseODE();
  }
  void step() {
    if (space_ != nullptr) {
      dSpaceCollide(space_, this, touch);
    } else {
      geoms_.collide(this, touch);
    }
    dWorldQuickStep(world_, kSeconds);
    dJointGroupEmpty(joints_);
  }

 private:
  void add(dGeomID geom, ObjectKind kind) {
    all_.push_back(geom);
    if (space_ == nullptr) geoms_.add(geom, kind);
  }
  void add_ball(const std::vector<double>& position, const std::vector<double>& velocity) {
    const dBodyID body = dBodyCreate(world_);
    const dGeomID ball = dCreateSphere(space_, 0.5);
    dGeomSetBody(ball, body);
    dBodySetPosition(body, position[0], position[1], position[2]);
    dBodySetLinearVel(body, velocity[0], velocity[1], velocity[2]);
    add(ball, ObjectKind::moving);
  }
  static void touch(void* data, dGeomID a, dGeomID b) {
    const auto& self = *static_cast<OdeScene*>(data);
    const dBodyID first = dGeomGetBody(a);
    const dBodyID second = dGeomGetBody(b);
    if (first == nullptr && second == nullptr) return;
    std::array<dContact, 2> contacts{};
    const int count = dCollide(a, b, 2, &contacts[0].geom, sizeof(dContact));
    for (int k = 0; k < count; ++k) {
      dContact& contact = contacts[static_cast<std::size_t>(k)];
      contact.surface.mode = self.gas_ ? dContactBounce : dContactApprox1;
      contact.surface.mu = self.gas_ ? 0 : 0.5;
      contact.surface.bounce = 1;
      dJointAttach(dJointCreateContact(self.world_, self.joints_, &contact), first, second);
    }
  }

  bool gas_;
  dWorldID world_ = nullptr;
  dJointGroupID joints_ = nullptr;
  dSpaceID space_ = nullptr;  ///< null: ours
  OdeGeoms geoms_;
  std::vector<dGeomID> all_;
};

}  // namespace

Contest ode_contest(const Start& start, bool sweep_and_prune) {
  const Structure structure = sweep_and_prune ? Structure::sweep_and_prune : Structure::hash;
  const auto own = std::make_shared<OdeScene>(start, structure);
  const auto ours = std::make_shared<OdeScene>(start, Structure::ours);
  return {"ODE",
          sweep_and_prune ? "dSweepAndPruneSpace" : "dHashSpace",
          [own] { own->step(); },
          [ours] { ours->step(); },
          {}};
}

}  // namespace kerf::adapters
