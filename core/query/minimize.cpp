#include "core/query/minimize.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "core/query/delta_debug.h"

namespace kerf {
namespace {

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

template <int D>
Scenario<D> leave_out_operators(const Scenario<D>& scenario, const Fails<D>& fails) {
  const std::vector<Acting> acting = acting_operators(scenario);
  const auto without_others = [&](const std::vector<Acting>& kept) {
    std::vector<Acting> left_out;
    for (const Acting& one : acting)
      if (std::ranges::find(kept, one) == kept.end()) left_out.push_back(one);
    return without_operators(scenario, left_out);
  };
  if (acting.empty() || fails(without_others({}))) return without_others({});
  return without_others(
      delta_debug(acting, [&](const std::vector<Acting>& kept) { return fails(without_others(kept)); }));
}

template <int D>
std::size_t size_of(const Scenario<D>& scenario) {
  return scenario.requests() + scenario.steps.size() + acting_operators(scenario).size();
}

}  // namespace

template <int D>
Scenario<D> start_late(Replayer<D>& replayer, std::uint32_t last, const Fails<D>& fails) {
  for (std::uint32_t rest = 1; rest < last; rest *= 2) {
    Scenario<D> late = scenario_of(replayer, last - rest, last);
    if (fails(late)) return late;
  }
  Scenario<D> whole = scenario_of(replayer, 0, last);
  if (fails(whole)) return whole;
  throw std::runtime_error(
      whole.info.decisions.empty()
          ? "the condition does not hold when the whole run is made again: there is nothing to minimize"
          : "the condition holds only because of a decision about one event (`kerf rerun`), and other "
            "objects "
            "or steps make other events: there is nothing to minimize");
}

template <int D>
Scenario<D> minimize(Scenario<D> scenario, const Fails<D>& fails) {
  for (std::size_t before = SIZE_MAX; size_of(scenario) < before;) {
    before = size_of(scenario);
    scenario = leave_out_objects(scenario, fails);
    scenario = leave_out_steps(scenario, fails);
    scenario = leave_out_operators(scenario, fails);
  }
  if (!fails(scenario))
    throw std::runtime_error(
        "the small run does not show the condition: the answers differ from time to time for the same run");
  return scenario;
}

#define KERF_INSTANTIATE(D)                                                         \
  template Scenario<D> start_late<D>(Replayer<D>&, std::uint32_t, const Fails<D>&); \
  template Scenario<D> minimize<D>(Scenario<D>, const Fails<D>&);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
