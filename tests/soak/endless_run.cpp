#include "tests/soak/endless_run.h"

#include <algorithm>
#include <array>
#include <ctime>
#include <string_view>
#include <variant>

#include "core/replay/oracle.h"
#include "frames/bench/bench_scene.h"
#include "frames/catalog/scene_catalog.h"
#include "frames/support/errors.h"

namespace kerf::test {
namespace {

constexpr std::string_view kBench = "bench:";
constexpr std::uint32_t kRecycle = 5;  ///< steps between two objects that fall anew
constexpr std::uint64_t kSeed = 1;

/// Processor time of this thread: other work on the machine does not count.
double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Two equal trees as one broad phase, with a clock on all that each does in a step. The lesser time counts:
/// what the machine does to one of them is not the tree's.
template <int D>
class TimedTrees final : public BroadPhase<D> {
 public:
  explicit TimedTrees(const Config& config) : trees_{Bsp<D>(config), Bsp<D>(config)} {}

  [[nodiscard]] std::string_view name() const override { return tree().name(); }
  Status insert(ObjectId object, const Box<D>& box, Mobility mobility) override {
    static_cast<void>(trees_[1].insert(object, box, mobility));
    return trees_[0].insert(object, box, mobility);
  }
  Status move(ObjectId object, const Box<D>& box) override {
    static_cast<void>(trees_[1].move(object, box));
    return trees_[0].move(object, box);
  }
  Status remove(ObjectId object) override {
    static_cast<void>(trees_[1].remove(object));
    return trees_[0].remove(object);
  }
  void step() override { seconds_ = std::min(time_step(trees_[0]), time_step(trees_[1])); }
  [[nodiscard]] std::span<const Pair> pairs() const override { return tree().pairs(); }

  [[nodiscard]] const Bsp<D>& tree() const { return trees_[0]; }
  [[nodiscard]] double seconds() const { return seconds_; }

 private:
  static double time_step(Bsp<D>& tree) {
    const double start = cpu_seconds();
    tree.step();
    return cpu_seconds() - start;
  }

  std::array<Bsp<D>, 2> trees_;
  double seconds_ = 0;
};

template <int D>
class TreeRun : public EndlessRun {
 public:
  explicit TreeRun(const Config& config) : timed_(config) {}

  double step() final {
    advance();
    return timed_.seconds();
  }
  [[nodiscard]] Statistics statistics() const final { return timed_.tree().statistics(); }
  void ask_oracle() const final {
    const PairJudgement judgement = judge_pairs(timed_.pairs(), oracle_pairs(timed_.tree().objects()));
    if (judgement.is_exact()) return;
    throw NotExact("the pairs are not exact: " + std::to_string(judgement.missed.size()) + " missed, " +
                   std::to_string(judgement.extra.size()) + " extra, " +
                   std::to_string(judgement.twice.size()) + " reported twice");
  }

 protected:
  TimedTrees<D>& timed() { return timed_; }

 private:
  virtual void advance() = 0;

  TimedTrees<D> timed_;
};

template <int D>
class SceneRun final : public TreeRun<D> {
 public:
  SceneRun(const SceneEntry<D>& entry, const Config& config, std::uint32_t objects, std::uint32_t growth)
      : TreeRun<D>(config), scene_(entry.make(this->timed(), {objects, growth, kRecycle, kSeed})) {}

 private:
  void advance() override { scene_->advance(); }

  std::unique_ptr<Scene<D>> scene_;
};

template <int D>
class MotionRun final : public TreeRun<D> {
 public:
  MotionRun(const BenchScene& scene, const Config& config, std::uint32_t objects)
      : TreeRun<D>(config), motion_(scene.make<D>(objects, kSeed)) {
    const auto boxes = motion_->boxes();
    for (std::uint32_t k = 0; k < boxes.size(); ++k) {
      const auto mobility = k < motion_->moving() ? Mobility::moving : Mobility::fixed;
      static_cast<void>(this->timed().insert({k}, boxes[k], mobility));
    }
  }

 private:
  void advance() override {
    motion_->advance();
    if (motion_->all_move())
      for (std::uint32_t k = 0; k < motion_->moving(); ++k) move({k});
    else
      for (const ObjectId object : motion_->moved()) move(object);
    this->timed().step();
  }
  void move(ObjectId object) {
    static_cast<void>(this->timed().move(object, motion_->boxes()[object.value]));
  }

  std::unique_ptr<Motion<D>> motion_;
};

}  // namespace

std::vector<std::string> endless_run_names() {
  std::vector<std::string> names;
  for (const BenchScene& scene : bench_scenes())
    for (const char* dimension : {"-2d", "-3d"})
      names.push_back(std::string(kBench).append(scene.name).append(dimension));
  for (const CatalogScene& scene : scene_catalog()) names.push_back(scene.name);
  return names;
}

std::unique_ptr<EndlessRun> make_endless_run(const std::string& name, const Config& config,
                                             std::uint32_t objects, std::uint32_t growth) {
  if (name.starts_with(kBench)) {
    const bool flat = name.ends_with("-2d");
    if (!flat && !name.ends_with("-3d")) throw UsageError("'" + name + "' lacks its dimension: -2d or -3d");
    const std::size_t length = name.size() - kBench.size() - std::string_view("-2d").size();
    const BenchScene& scene = find_bench_scene(name.substr(kBench.size(), length));
    if (flat) return std::make_unique<MotionRun<2>>(scene, config, objects);
    return std::make_unique<MotionRun<3>>(scene, config, objects);
  }
  return std::visit(
      [&]<int D>(const SceneEntry<D>* entry) -> std::unique_ptr<EndlessRun> {
        return std::make_unique<SceneRun<D>>(*entry, config, objects, growth);
      },
      find_scene(name).entry);
}

}  // namespace kerf::test
