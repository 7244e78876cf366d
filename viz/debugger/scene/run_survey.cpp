#include "viz/debugger/scene/run_survey.h"

#include <algorithm>
#include <cmath>

#include "viz/debugger/scene/tints.h"
#include "viz/draw/frame_planner.h"
#include "viz/draw/recorded_bodies.h"
#include "viz/draw/view_box.h"

namespace kerf {
namespace {

constexpr std::uint32_t kMoments = 4;

/// The next of 1, 2, 5, 10, 20, 50 and so on.
double rounded_up(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(std::max(1.0, value))));
  for (const double step : {1.0, 2.0, 5.0})
    if (value <= step * power) return step * power;
  return 10 * power;
}

}  // namespace

template <int D>
RunSurvey<D> survey(RunOf<D>& run) {
  const Position now = run.position();
  SceneBox<D> box;
  RunSurvey<D> seen;
  std::uint32_t objects = 0;
  for (std::uint32_t k = 1; k <= kMoments; ++k) {
    run.go(Position::end_of(run.steps() * k / kMoments));
    box.update(recorded_bodies(run.state().latest));
    const TreeMoment moment{run.tree(), run.position().step, {}};
    objects = std::max(objects, run.state().tree.objects());
    seen.population_end = std::max(seen.population_end, find_tints(moment, Tint::population).end);
    seen.cost_end = std::max(seen.cost_end, find_tints(moment, Tint::cost).end);
  }
  // Of one crowded leaf, the colours of the others would be all alike.
  seen.population_end = std::min<double>(seen.population_end, end_of_ramp(objects, run.config()));
  run.go(now);
  seen.box = box.box();
  seen.cost_end = rounded_up(seen.cost_end);
  return seen;
}

template RunSurvey<2> survey(RunOf<2>& run);
template RunSurvey<3> survey(RunOf<3>& run);

}  // namespace kerf
