#include "sims3d/sleep.h"

namespace kerf {
namespace {

bool is_slower(const dReal* velocity, double speed) {
  return dCalcVectorDot3(velocity, velocity) < speed * speed;
}

}  // namespace

void Sleep::observe(ObjectId object, dBodyID body) {
  if (object.index() >= slow_steps_.size()) slow_steps_.resize(object.index() + 1, 0);
  std::uint32_t& slow_steps = slow_steps_[object.index()];
  const bool slow =
      is_slower(dBodyGetLinearVel(body), rule_.linear) && is_slower(dBodyGetAngularVel(body), rule_.angular);
  slow_steps = slow ? slow_steps + 1 : 0;
  if (!rule_.allowed || slow_steps < rule_.steps) return;
  dBodySetLinearVel(body, 0, 0, 0);
  dBodySetAngularVel(body, 0, 0, 0);
  dBodyDisable(body);
}

void Sleep::wake(ObjectId object, dBodyID body) {
  if (object.index() < slow_steps_.size()) slow_steps_[object.index()] = 0;
  dBodyEnable(body);
}

}  // namespace kerf
