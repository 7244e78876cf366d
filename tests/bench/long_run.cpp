// A long run of a 3D scene: the tree drives it, ODE's hash space is shown the same boxes, the oracle looks
// on. usage: kerf_long_run [SCENE [OBJECTS [STEPS [JSON-FILE [CONFIGURATION]]]]]

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/broad_phase/brute_force.h"
#include "core/bsp/bsp.h"
#include "core/tree/validate.h"
#include "sims3d/rivals/ode_space.h"
#include "sims3d/scenes/scenes.h"

namespace {

using namespace kerf;

constexpr std::uint32_t kOracleInterval = 50;
constexpr std::uint32_t kRowInterval = 500;

/// Seconds that each step of one broad phase took, its updates included.
class Clock {
 public:
  template <class Work>
  auto time(Work work) {
    const auto start = std::chrono::steady_clock::now();
    struct Stop {
      Clock& clock;
      std::chrono::steady_clock::time_point start;
      ~Stop() {
        clock.step_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      }
    } stop{*this, start};
    return work();
  }
  void end_step() {
    steps_.push_back(step_);
    step_ = 0;
  }
  /// The value that the share `rank` of the steps does not exceed, in milliseconds.
  [[nodiscard]] double quantile(double rank) const {
    std::vector<double> sorted = steps_;
    std::sort(sorted.begin(), sorted.end());
    return sorted.empty()
               ? 0
               : 1e3 * sorted[static_cast<std::size_t>(rank * static_cast<double>(sorted.size() - 1))];
  }

 private:
  std::vector<double> steps_;
  double step_ = 0;
};

/// The tree as the scene's broad phase; every request goes to the rival and the oracle too.
class Watched final : public BroadPhase<3> {
 public:
  Watched(BroadPhase<3>& tree, BroadPhase<3>& rival) : tree_(tree), rival_(rival) {}
  [[nodiscard]] std::string_view name() const override { return tree_.name(); }
  Status insert(ObjectId object, const Box<3>& box, Mobility mobility) override {
    (void)oracle_.insert(object, box, mobility);
    (void)rival_clock.time([&] { return rival_.insert(object, box, mobility); });
    return tree_clock.time([&] { return tree_.insert(object, box, mobility); });
  }
  Status move(ObjectId object, const Box<3>& box) override {
    ++moved;
    moves_.push_back({object, box});
    return oracle_.move(object, box);
  }
  Status remove(ObjectId object) override {
    (void)oracle_.remove(object);
    (void)rival_.remove(object);
    return tree_.remove(object);
  }
  void step() override {
    run(tree_, tree_clock);
    run(rival_, rival_clock);
    moves_.clear();
    if (++steps_ % kOracleInterval == 0) compare();
  }
  [[nodiscard]] std::span<const Pair> pairs() const override { return tree_.pairs(); }

  Clock tree_clock;
  Clock rival_clock;
  std::uint32_t compared = 0;
  std::uint64_t missed = 0;
  std::uint64_t extra = 0;
  std::uint64_t rival_differs = 0;
  std::uint64_t moved = 0;

 private:
  struct Move {
    ObjectId object;
    Box<3> box;
  };

  void run(BroadPhase<3>& broad_phase, Clock& clock) {
    clock.time([&] {
      for (const Move& move : moves_) (void)broad_phase.move(move.object, move.box);
      broad_phase.step();
    });
    clock.end_step();
  }

  static std::vector<Pair> sorted(std::span<const Pair> pairs) {
    std::vector<Pair> result(pairs.begin(), pairs.end());
    std::sort(result.begin(), result.end());
    return result;
  }

  void compare() {
    oracle_.step();
    const std::vector<Pair> expected = sorted(oracle_.pairs());
    const std::vector<Pair> found = sorted(tree_.pairs());
    std::vector<Pair> difference;
    std::set_difference(expected.begin(), expected.end(), found.begin(), found.end(),
                        std::back_inserter(difference));
    missed += difference.size();
    difference.clear();
    std::set_difference(found.begin(), found.end(), expected.begin(), expected.end(),
                        std::back_inserter(difference));
    extra += difference.size();
    if (sorted(rival_.pairs()) != expected) ++rival_differs;
    ++compared;
  }

  BroadPhase<3>& tree_;
  BroadPhase<3>& rival_;
  BruteForce<3> oracle_;
  std::vector<Move> moves_;
  std::uint32_t steps_ = 0;
};

const SceneEntry<3>& find_scene(const std::string& name) {
  for (const SceneEntry<3>& entry : scenes_3d())
    if (entry.name == name) return entry;
  throw std::invalid_argument("there is no 3D scene '" + name + "'");
}

nlohmann::json row(const Scene<3>& scene, const Statistics& s) {
  return {{"step", scene.step()},
          {"objects", s.objects},
          {"pairs", scene.pairs().size()},
          {"contacts", scene.contacts().size()},
          {"height", s.height},
          {"leaves", s.leaves},
          {"entries", s.entries},
          {"redundancy", s.redundancy},
          {"operators", s.operators}};
}

nlohmann::json run(const std::string& scene_name, std::uint32_t objects, std::uint32_t steps,
                   const Config& config) {
  Bsp<3> tree(config);
  OdeSpace rival(OdeSpaceKind::hash, Box<3>{});
  Watched watched(tree, rival);
  const auto scene = find_scene(scene_name).make(watched, {objects, steps / 4 * 3, 1});
  nlohmann::json rows = nlohmann::json::array();
  std::printf("%6s %8s %8s %8s %7s %7s %8s %10s %6s\n", "step", "objects", "pairs", "contacts", "height",
              "leaves", "entries", "redundancy", "sound");
  while (scene->step() < steps) {
    scene->advance();
    if (scene->step() % kRowInterval != 0) continue;
    const Statistics s = tree.statistics();
    std::printf("%6u %8u %8zu %8zu %7u %7u %8lu %10.3f %6s\n", scene->step(), s.objects,
                scene->pairs().size(), scene->contacts().size(), s.height, s.leaves, s.entries, s.redundancy,
                validate(tree.tree()).empty() ? "yes" : "NO");
    std::fflush(stdout);
    rows.push_back(row(*scene, s));
  }
  const auto times = [](const Clock& clock) {
    return nlohmann::json{
        {"median_ms", clock.quantile(0.5)}, {"p99_ms", clock.quantile(0.99)}, {"max_ms", clock.quantile(1)}};
  };
  return {{"scene", scene_name},
          {"objects", objects},
          {"steps", steps},
          {"moves_a_step", static_cast<double>(watched.moved) / steps},
          {"oracle_steps", watched.compared},
          {"missed", watched.missed},
          {"extra", watched.extra},
          {"rival_differs", watched.rival_differs},
          {"kerf", times(watched.tree_clock)},
          {"ode-hash", times(watched.rival_clock)},
          {"rows", rows}};
}

}  // namespace

int main(int argc, char** argv) try {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  const auto argument = [&](std::size_t k, const char* otherwise) {
    return k < arguments.size() ? arguments[k] : std::string(otherwise);
  };
  Config config;
  kerf::apply(config, argument(4, ""));  // std::apply is a candidate otherwise
  const auto result = run(argument(0, "buckets"), static_cast<std::uint32_t>(std::stoul(argument(1, "4250"))),
                          static_cast<std::uint32_t>(std::stoul(argument(2, "6000"))), config);
  std::printf("oracle: %d steps compared, %d missed, %d extra; moved %.0f objects a step\n",
              result["oracle_steps"].get<int>(), result["missed"].get<int>(), result["extra"].get<int>(),
              result["moves_a_step"].get<double>());
  for (const char* name : {"kerf", "ode-hash"})
    std::printf("%-10s median %.3f ms, p99 %.3f ms, max %.3f ms a step\n", name,
                result[name]["median_ms"].get<double>(), result[name]["p99_ms"].get<double>(),
                result[name]["max_ms"].get<double>());
  if (const std::string path = argument(3, ""); !path.empty()) std::ofstream(path) << result.dump(2) << '\n';
  return result["missed"] == 0 && result["extra"] == 0 ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "kerf_long_run: %s\n", error.what());
  return 2;
}
