#include "core/query/minimize.h"

#include <algorithm>
#include <numeric>

#include "core/query/delta_debug.h"

namespace kerf {
namespace {

template <int D>
using Fails = std::function<bool(const Scenario<D>&)>;

/// Starts as late as it still fails: 1, 2, 4, ... steps before the end are tried.
template <int D>
Scenario<D> start_late(const Scenario<D>& scenario, const Fails<D>& fails) {
  for (std::size_t rest = 1; rest + 1 < scenario.steps.size(); rest *= 2) {
    Scenario<D> late = starting_late(scenario, scenario.steps.size() - rest);
    if (fails(late)) return late;
  }
  return scenario;
}

template <int D>
Scenario<D> leave_out_objects(const Scenario<D>& scenario, const Fails<D>& fails) {
  const auto kept = delta_debug(objects_of(scenario), [&](const std::vector<ObjectId>& objects) {
    return fails(with_objects(scenario, objects));
  });
  return with_objects(scenario, kept);
}

template <int D>
Scenario<D> leave_out_steps(const Scenario<D>& scenario, const Fails<D>& fails) {
  std::vector<std::size_t> all(scenario.steps.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const auto kept = delta_debug(all, [&](const std::vector<std::size_t>& steps) {
    return !steps.empty() && fails(with_steps(scenario, steps));
  });
  return with_steps(scenario, kept);
}

}  // namespace

template <int D>
Scenario<D> minimize(Scenario<D> scenario, const std::function<bool(const Scenario<D>&)>& fails) {
  scenario = start_late(scenario, fails);
  for (std::size_t before = SIZE_MAX; scenario.requests() + scenario.steps.size() < before;) {
    before = scenario.requests() + scenario.steps.size();
    scenario = leave_out_objects(scenario, fails);
    scenario = leave_out_steps(scenario, fails);
  }
  return scenario;
}

template Scenario<2> minimize<2>(Scenario<2>, const std::function<bool(const Scenario<2>&)>&);
template Scenario<3> minimize<3>(Scenario<3>, const std::function<bool(const Scenario<3>&)>&);

}  // namespace kerf
