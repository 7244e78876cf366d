#include "frames/experiment/simulation.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <utility>

#include "core/bsp/bsp.h"
#include "core/objects/broad_phase.h"
#include "core/objects/object_table.h"
#include "core/recording/step_requests.h"
#include "frames/bench/step_block.h"
#include "frames/bench/structure.h"
#include "frames/bench/truth.h"
#include "frames/catalog/broad_phase_choice.h"
#include "frames/catalog/scene_catalog.h"
#include "frames/experiment/reading.h"
#include "frames/rivals/step_timer.h"

namespace kerf {
namespace {

/// A broad phase in the experiment.
class Contestant {
 public:
  explicit Contestant(std::unique_ptr<BroadPhase<3>> subject);

  /// Passes on the requests, does a step, and returns its cost, without candidates.
  ContestantStep step(const StepRequests<3>& requests);
  /// How many pairs of boxes its structure left to be compared in the last step; negative: unknown.
  [[nodiscard]] double count_candidates() const;
  [[nodiscard]] const BroadPhase<3>& subject() const { return *subject_; }

 private:
  std::unique_ptr<BroadPhase<3>> subject_;
};

Contestant::Contestant(std::unique_ptr<BroadPhase<3>> subject) : subject_(std::move(subject)) {
  measure_parts(*subject_);
}

double Contestant::count_candidates() const {
  const auto count = candidates_of(*subject_);
  return count ? static_cast<double>(*count) : -1;
}

ContestantStep Contestant::step(const StepRequests<3>& requests) {
  const SplitCost cost = costed_step(requests, *subject_);
  ContestantStep result;
  result.update = cost.overhead.value();  // all contestants measure it
  result.collision = cost.total - result.update;
  if (const auto* tree = dynamic_cast<const Bsp<3>*>(subject_.get())) {
    const Statistics statistics = tree->statistics();
    result.height = statistics.height;
    result.leaves = statistics.leaves;
    for (const std::uint64_t acted : statistics.operators) result.operators += acted;
  }
  return result;
}

constexpr std::array<Simulation, 4> kSimulations{{{1, "terrain", "objects fall into a terrain"},
                                                  {2, "attractors", "clouds follow moving attractors"},
                                                  {3, "fracture", "blocks collide and break"},
                                                  {4, "buckets", "objects fall into buckets"}}};

constexpr std::array<std::string_view, 7> kContestants{
    "kerf-paper", "ode-quadtree", "ode-hash", "loose-octree", "sweep-and-prune", "kerf", "ode-sap"};
constexpr std::array<std::string_view, 7> kPaperNames{"BSP", "QT", "SH", "LO", "SP", "tuned BSP", "ODE SAP"};

/// Parameters behind the colons of a reading's name, on top of the paper's.
Config config_of_reading(std::string_view contestant) {
  std::string parameters(contestant.substr(std::min(contestant.size(), kPaperTree.size() + 1)));
  std::ranges::replace(parameters, ':', ',');
  Config config;
  if (!parameters.empty()) kerf::apply(config, parameters);
  return config;
}

/// Makes the C library sort what was freed. It leaves that to the next request for a large piece: a step of
/// one broad phase would be timed with what others have freed, up to milliseconds of it.
void settle_heap() {
  constexpr std::size_t kLarge = std::size_t{100} << 10U;  // not so large that it is mapped by itself
  void* volatile piece = std::malloc(kLarge);  // volatile: the compiler may leave out what is not used
  std::free(piece);
}

/// Stands in the world's loop and has all contestants do each step.
class Chorus final : public BroadPhase<3> {
 public:
  Chorus(const SceneEntry<3>& entry, const SceneOptions& options, const Lineup& lineup)
      : counts_(lineup.counts) {
    for (const std::string_view name : lineup.names) {
      BroadPhaseChoice choice = choose_broad_phase(name.substr(0, name.find(':')), entry.needs);
      if (choice.name == kPaperTree) choice.config = config_of_reading(name);
      contestants_.emplace_back(make_broad_phase<3>(choice, entry, options));
    }
  }

  [[nodiscard]] std::string_view name() const override { return "chorus"; }
  Status insert(ObjectId object, const Box<3>& box, Mobility mobility) override {
    requests_.add_insert(object, box, mobility);
    return table_.insert(object, box, mobility);
  }
  Status move(ObjectId object, const Box<3>& box) override {
    moved_.push_back(object);
    boxes_.push_back(box);
    return table_.move(object, box);
  }
  Status remove(ObjectId /*object*/) override {
    throw std::logic_error("no scene of the experiment removes objects");
  }

  void step() override {
    const StepTimer timer(true);
    requests_.add_moves(moved_, boxes_);
    results_.assign(contestants_.size(), {});
    // Each in turn begins, because later ones find warmer caches.
    for (std::size_t k = 0; k < contestants_.size(); ++k) {
      settle_heap();
      const std::size_t turn = (k + steps_) % contestants_.size();
      results_[turn] = contestants_[turn].step(requests_);
    }
    // Only when all are timed, since counting leaves the caches full of other things.
    if (counts_ && steps_ % kBetweenCounts == 0)
      for (std::size_t k = 0; k < contestants_.size(); ++k)
        results_[k].candidates = contestants_[k].count_candidates();
    ++steps_;
    compare();
    requests_.clear();
    moved_.clear();
    boxes_.clear();
    milliseconds_ = timer.milliseconds();
  }
  [[nodiscard]] std::span<const Pair> pairs() const override { return contestants_[0].subject().pairs(); }

  /// Of the last step.
  [[nodiscard]] const std::vector<ContestantStep>& results() const { return results_; }
  [[nodiscard]] double step_milliseconds() const { return milliseconds_; }

 private:
  static constexpr std::uint32_t kBetweenCounts = 5;

  void compare() {
    const Truth truth = truth_of(pairs());
    for (std::size_t k = 1; k < contestants_.size(); ++k) {
      const std::span<const Pair> found = contestants_[k].subject().pairs();
      if (truth_of(found) == truth) continue;
      const Difference difference = kerf::compare(found, {pairs().begin(), pairs().end()});
      results_[k].wrong = difference.missed + difference.extra;
    }
  }

  ObjectTable<3> table_;
  std::vector<Contestant> contestants_;
  StepRequests<3> requests_;  ///< insertions first, then moves, all in one call
  std::vector<ObjectId> moved_;
  std::vector<Box<3>> boxes_;
  std::vector<ContestantStep> results_;
  double milliseconds_ = 0;
  std::uint32_t steps_ = 0;
  bool counts_;
};

}  // namespace

std::span<const Simulation> simulations() { return kSimulations; }
std::span<const std::string_view> contestants() {
  static const std::vector<std::string_view> kAll = [] {
    std::vector<std::string_view> names(kContestants.begin(), kContestants.end());
    for (const Reading& reading : readings().subspan(1)) names.push_back(reading.contestant);
    return names;
  }();
  return kAll;
}

std::span<const std::string_view> contestants_in_figures() { return kContestants; }

std::span<const std::string_view> contestants_in(std::uint32_t repeat) {
  return repeat == 1 ? contestants() : contestants_in_figures();
}

std::string_view paper_name(std::string_view contestant) {
  const auto found = std::ranges::find(kContestants, contestant);
  return kPaperNames.at(static_cast<std::size_t>(found - kContestants.begin()));
}

ExperimentRuns first_repeats(const ExperimentRuns& runs) {
  ExperimentRuns first;
  for (std::size_t k = 0; k < runs.size(); ++k)
    std::ranges::copy_if(runs[k], std::back_inserter(first[k]),
                         [](const TimedRun& run) { return run.repeat == 1; });
  return first;
}

ExperimentRun run_simulation(const Simulation& simulation, const ExperimentSize& size, const Lineup& lineup,
                             const std::function<bool(std::uint32_t step)>& watch) {
  const CatalogScene found = find_scene(simulation.scene);
  const SceneEntry<3>& entry = *std::get<const SceneEntry<3>*>(found.entry);
  SceneOptions options{.objects = size.objects, .seed = size.seed};
  if (entry.grows) options.steps = size.steps;
  Chorus chorus(entry, options, lineup);
  const std::unique_ptr<Scene<3>> scene = entry.make(chorus, options);
  ExperimentRun run;
  for (std::uint32_t step = 1; step <= size.steps && watch(step); ++step) {
    const StepTimer timer(true);
    scene->advance();
    ExperimentStep& row = run.emplace_back();
    row.rest = timer.milliseconds() - chorus.step_milliseconds();
    row.step = step;
    row.moving =
        static_cast<std::uint32_t>(std::ranges::count(scene->bodies(), Mobility::moving, &Body<3>::mobility));
    row.pairs = scene->pairs().size();
    row.contacts = scene->contacts().size();
    row.contestants = chorus.results();
  }
  return run;
}

}  // namespace kerf
