#include "frames/rivals/makers.h"
#include "sims3d/rivals/ode_space.h"

namespace kerf {
namespace {

std::unique_ptr<BroadPhase<3>> make_space(OdeSpaceKind kind, const RivalHints<3>& hints, Intake intake) {
  return std::make_unique<OdeSpace>(kind, hints.bounds,
                                    intake == Intake::raw ? OdeIntake::raw : OdeIntake::checked,
                                    hints.separating[2] ? OdePlane::xz : OdePlane::xy);
}

}  // namespace

std::unique_ptr<BroadPhase<3>> make_ode_hash(const RivalHints<3>& hints, Intake intake) {
  return make_space(OdeSpaceKind::hash, hints, intake);
}

std::unique_ptr<BroadPhase<3>> make_ode_quadtree(const RivalHints<3>& hints, Intake intake) {
  return make_space(OdeSpaceKind::quadtree, hints, intake);
}

std::unique_ptr<BroadPhase<3>> make_ode_sweep_and_prune(const RivalHints<3>& hints, Intake intake) {
  return make_space(OdeSpaceKind::sweep_and_prune, hints, intake);
}

}  // namespace kerf
