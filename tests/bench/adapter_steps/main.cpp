// kerf_adapter_steps [STEPS]: processor time of a step of each engine with its own broad phase and with ours,
// 4,250 objects, step by step in turn. Prints a table for docs/ADAPTERS.md and, as the last line, JSON.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/base/random.h"
#include "tests/bench/adapter_steps/contest.h"

namespace kerf::adapters {

Start make_start(const std::string& scene, int dimension) {
  const bool heap = scene == "heap";
  Start start;
  start.gravity = heap ? 10 : 0;
  start.side = dimension == 3 ? (heap ? 20 : 36) : (heap ? 100 : 130);
  Random random(1);
  const double gap = heap ? 1.1 : (start.side - 2) / std::ceil(std::pow(kObjects, 1.0 / dimension));
  const int across = static_cast<int>((start.side - 2) / gap);
  for (int k = 0; k < kObjects; ++k) {
    const int row = k / across;
    const int cells[3] = {k % across, dimension == 2 ? row : row / across, row % across};
    std::vector<double> position;
    std::vector<double> velocity;
    for (int i = 0; i < dimension; ++i) {
      position.push_back(1 + gap * (cells[i] + random.uniform(0.45, 0.55)));
      velocity.push_back(heap ? 0 : random.uniform(-6, 6));
    }
    start.positions.push_back(position);
    start.velocities.push_back(velocity);
  }
  return start;
}

namespace {

double milliseconds_of(const std::function<void()>& step) {
  std::timespec begin{};
  std::timespec end{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &begin);
  step();
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &end);
  return 1e3 * static_cast<double>(end.tv_sec - begin.tv_sec) +
         1e-6 * static_cast<double>(end.tv_nsec - begin.tv_nsec);
}

double median(std::vector<double> values) {
  std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
  return values[values.size() / 2];
}

/// Steps both in turn; the first third of the steps is left out.
nlohmann::json run(const Contest& contest, const std::string& scene, int steps) {
  std::vector<double> own;
  std::vector<double> ours;
  for (int step = 0; step < steps; ++step) {
    const double theirs = milliseconds_of(contest.step_own);
    const double with_ours = milliseconds_of(contest.step_ours);
    if (3 * step < steps) continue;
    own.push_back(theirs);
    ours.push_back(with_ours);
  }
  const double a = median(own);
  const double b = median(ours);
  std::printf("| %s | `%s` | %s | %.2f | %.2f | %.2f |\n", contest.engine.c_str(), contest.own.c_str(),
              scene.c_str(), a, b, a / b);
  std::fflush(stdout);
  return {{"engine", contest.engine}, {"own", contest.own}, {"scene", scene}, {"own_ms", a}, {"ours_ms", b}};
}

}  // namespace
}  // namespace kerf::adapters

int main(int argc, char** argv) {
  using namespace kerf::adapters;  // NOLINT(google-build-using-namespace)
  const int steps = argc > 1 ? std::atoi(argv[1]) : 300;
  if (steps < 3) {
    std::fprintf(stderr, "usage: kerf_adapter_steps [STEPS], at least 3\n");
    return 2;
  }
  std::puts(
      "| engine | its broad phase | scene | ms a step | with ours | times as fast "
      "|\n|---|---|---|---|---|---|");
  nlohmann::json rows = nlohmann::json::array();
  for (const std::string scene : {"heap", "gas"}) {
    const Start solid = make_start(scene, 3);
    rows.push_back(run(bullet_contest(solid), scene, steps));
    rows.push_back(run(ode_contest(solid, false), scene, steps));
    rows.push_back(run(ode_contest(solid, true), scene, steps));
    rows.push_back(run(fcl_contest(solid), scene, steps));
    rows.push_back(run(box2d_contest(make_start(scene, 2)), scene, steps));
  }
  std::printf("%s\n", nlohmann::json{{"objects", kObjects}, {"steps", steps}, {"rows", rows}}.dump().c_str());
}
