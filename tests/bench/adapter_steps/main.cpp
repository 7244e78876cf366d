// kerf_adapter_steps [STEPS]: processor time of a step of each engine with its own broad phase and with ours,
// 4,250 objects, step by step in turn, and of 100 queries of each kind after each step. Prints two tables for
// docs/ADAPTERS.md and, as the last line, JSON.

#include <algorithm>
#include <array>
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
  for (int k = 0; k < kRays; ++k) {
    std::vector<double> ray;
    for (int i = 0; i < dimension; ++i) ray.push_back(random.uniform(0, start.side));
    for (int i = 0; i < dimension; ++i)
      ray.push_back(ray[static_cast<std::size_t>(i)] + random.uniform(-10, 10));
    start.rays.push_back(ray);
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

/// What the engine's own broad phase takes and what ours does, of each step.
struct Times {
  std::vector<double> own;
  std::vector<double> ours;

  /// One after the other.
  template <class Own, class Ours>
  void measure(Own run_own, Ours run_ours, bool counts) {
    const double a = milliseconds_of(run_own);
    const double b = milliseconds_of(run_ours);
    if (!counts) return;
    own.push_back(a);
    ours.push_back(b);
  }
};

/// A row's times: of both, and their ratio.
std::string to_text(double own, double ours) {
  std::array<char, 100> text{};
  std::snprintf(text.data(), text.size(), "%.2f | %.2f | %.2f |\n", own, ours, own / ours);
  return text.data();
}

/// Steps both in turn; the first third of the steps is left out. Prints the row of a step, returns those of
/// queries.
std::string run(const Contest& contest, const std::string& scene, const Start& start, int steps,
                nlohmann::json& rows) {
  Times step_times;
  std::vector<Times> query_times(contest.asked.size());
  for (int step = 0; step < steps; ++step) {
    const bool counts = 3 * step >= steps;
    step_times.measure(contest.step_own, contest.step_ours, counts);
    for (std::size_t k = 0; k < contest.asked.size(); ++k)
      query_times[k].measure([&] { contest.asked[k].own(start); }, [&] { contest.asked[k].ours(start); },
                             counts);
  }
  const std::string begin = "| " + contest.engine + " | `" + contest.own + "` | " + scene + " | ";
  const double own = median(step_times.own);
  const double ours = median(step_times.ours);
  std::printf("%s%s", begin.c_str(), to_text(own, ours).c_str());
  std::fflush(stdout);
  nlohmann::json queries = nlohmann::json::array();
  std::string text;
  for (std::size_t k = 0; k < contest.asked.size(); ++k) {
    const double own_us = 1e3 / kRays * median(query_times[k].own);
    const double our_us = 1e3 / kRays * median(query_times[k].ours);
    queries.push_back({{"what", contest.asked[k].what}, {"own_us", own_us}, {"ours_us", our_us}});
    text += begin + contest.asked[k].what + " | " + to_text(own_us, our_us);
  }
  rows.push_back({{"engine", contest.engine},
                  {"own", contest.own},
                  {"scene", scene},
                  {"own_ms", own},
                  {"ours_ms", ours},
                  {"queries", queries}});
  return text;
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
  std::string queries;
  for (const std::string scene : {"heap", "gas"}) {
    const Start solid = make_start(scene, 3);
    const Start flat = make_start(scene, 2);
    queries += run(bullet_contest(solid), scene, solid, steps, rows);
    queries += run(ode_contest(solid, false), scene, solid, steps, rows);
    queries += run(ode_contest(solid, true), scene, solid, steps, rows);
    queries += run(fcl_contest(solid), scene, solid, steps, rows);
    queries += run(box2d_contest(flat), scene, flat, steps, rows);
  }
  std::printf(
      "\n| engine | its broad phase | scene | query | us a query | with ours | times as fast |\n"
      "|---|---|---|---|---|---|---|\n%s\n",
      queries.c_str());
  std::printf("%s\n", nlohmann::json{{"objects", kObjects}, {"steps", steps}, {"rows", rows}}.dump().c_str());
}
