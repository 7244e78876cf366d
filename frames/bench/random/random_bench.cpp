#include "frames/bench/random/random_bench.h"

#include <utility>

#include "frames/bench/random/random_motion.h"

namespace kerf {
namespace {

CellPlan plan_of_random(const BenchRequest& request, const RandomScene& scene) {
  CellPlan plan;
  plan.scene = "random " + std::to_string(scene.number);
  plan.objects = scene.objects;
  plan.algorithms = request.algorithms;
  plan.rounds = request.rounds;
  plan.warm_up = request.warm_up_for(scene.objects);
  plan.steps = request.steps_for(scene.objects);
  plan.seed = request.seed;
  plan.patience = request.patience;
  return plan;
}

template <int D>
CellResult measure_scene(const BenchRequest& request, const RandomScene& scene, const CellWatch& watch) {
  const CellPlan plan = plan_of_random(request, scene);
  const MotionSource<D> source = [&] { return make_random_motion<D>(scene, plan.warm_up + plan.steps); };
  return measure_cell<D>(plan, source, watch);
}

}  // namespace

void measure_random(const BenchRequest& request, const CellWatch& watch,
                    const std::function<void(RandomOutcome)>& add) {
  for (std::uint32_t k = 0; k < request.random; ++k) {
    const RandomScene scene = draw_scene(request.seed, request.first + k, request.most);
    watch.progress("drawing random scene " + std::to_string(scene.number));
    CellResult cell = scene.dimension == 2 ? measure_scene<2>(request, scene, watch)
                                           : measure_scene<3>(request, scene, watch);
    if (watch.stop()) return;
    add({scene, std::move(cell)});
  }
}

}  // namespace kerf
