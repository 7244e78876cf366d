#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "core/base/median.h"
#include "core/bsp/bsp.h"
#include "core/objects/broad_phase.h"
#include "core/recording/chain.h"
#include "core/recording/recording_info.h"
#include "core/recording/step_requests.h"
#include "frames/bench/loop_watch.h"
#include "frames/bench/structure.h"
#include "frames/bench/truth.h"
#include "frames/catalog/algorithm.h"
#include "frames/catalog/broad_phase_choice.h"
#include "frames/study/estimate.h"
#include "frames/study/measure.h"
#include "frames/study/study.h"

namespace kerf {
namespace {

/// What a broad phase is asked in the steps of a cell's motion or scene, computed beside it, so that every
/// broad phase is asked the same.
template <int D>
class Feed {
 public:
  Feed() = default;
  Feed(const Feed&) = delete;
  Feed& operator=(const Feed&) = delete;
  virtual ~Feed() = default;

  /// The objects that are there before the first step.
  [[nodiscard]] virtual StepRequests<D> begin() { return {}; }
  /// The requests of the next step.
  virtual StepRequests<D> next() = 0;
  /// An empty broad phase for them, without knowledge of what they will be but where that is needed.
  [[nodiscard]] virtual std::unique_ptr<BroadPhase<D>> make_subject(const std::string& name) const = 0;
};

/// A motion of `kerf bench`, the same boxes as there.
template <int D>
class MotionFeed final : public Feed<D> {
 public:
  MotionFeed(const BenchScene& scene, const SceneOptions& options)
      : motion_(scene.make<D>(options.objects, options.seed)), all_(motion_->moving()) {
    for (std::uint32_t k = 0; k < all_.size(); ++k) all_[k] = {k};
  }

  [[nodiscard]] StepRequests<D> begin() override {
    StepRequests<D> requests;
    for (std::uint32_t k = 0; k < motion_->boxes().size(); ++k)
      requests.add_insert({k}, motion_->boxes()[k],
                          k < motion_->moving() ? Mobility::moving : Mobility::fixed);
    return requests;
  }
  StepRequests<D> next() override {
    motion_->advance();
    const std::span<const ObjectId> moved = motion_->all_move() ? all_ : motion_->moved();
    std::vector<Box<D>> boxes;
    for (const ObjectId object : moved) boxes.push_back(motion_->boxes()[object.index()]);
    StepRequests<D> requests;
    requests.add_moves(moved, boxes);
    return requests;
  }
  [[nodiscard]] std::unique_ptr<BroadPhase<D>> make_subject(const std::string& name) const override {
    const auto count = static_cast<std::uint32_t>(motion_->boxes().size());
    return find_algorithm<D>(name)->make({motion_->bounds(), motion_->box_size(), count}, 1);
  }

 private:
  std::unique_ptr<Motion<D>> motion_;
  std::vector<ObjectId> all_;
};

/// A scene with the tuned tree in its loop; every exact broad phase leads to the same run.
template <int D>
class SceneFeed final : public Feed<D> {
 public:
  SceneFeed(const SceneEntry<D>& entry, const SceneOptions& options)
      : entry_(entry),
        options_(options),
        driver_(tuned_config()),
        watch_(driver_, [] { return 0.0; }),
        scene_(entry.make(watch_, options)) {}

  StepRequests<D> next() override {
    scene_->advance();
    return std::move(watch_.take().front().requests);
  }
  [[nodiscard]] std::unique_ptr<BroadPhase<D>> make_subject(const std::string& name) const override {
    const bool is_tree = name.starts_with(kTunedTree);
    if (is_tree) return find_algorithm<D>(name)->make({}, 1);
    BroadPhaseChoice choice = choose_broad_phase(name, entry_.needs);
    choice.volume = VolumeKind::box;
    return make_broad_phase<D>(choice, entry_, options_);
  }

 private:
  const SceneEntry<D>& entry_;
  SceneOptions options_;
  Bsp<D> driver_;
  LoopWatch<D> watch_;
  std::unique_ptr<Scene<D>> scene_;
};

template <int D>
std::unique_ptr<Feed<D>> feed_of(const BenchScene* motion, const SceneOptions& options) {
  return std::make_unique<MotionFeed<D>>(*motion, options);
}

template <int D>
std::unique_ptr<Feed<D>> feed_of(const CatalogScene& scene, const SceneOptions& options) {
  return std::make_unique<SceneFeed<D>>(*std::get<const SceneEntry<D>*>(scene.entry), options);
}

template <int D>
std::unique_ptr<Feed<D>> make_feed(const RunCell& cell) {
  return std::visit([&](const auto& scene) { return feed_of<D>(scene, cell.options); }, cell.scene);
}

/// Steps that are computed before the broad phase does them in a row: their computation would leave it cold
/// caches. Fewer if their boxes take more memory than this.
constexpr std::size_t kBlock = 16;
constexpr std::size_t kBlockBytes = std::size_t{128} << 20U;

/// Calls `visit(requests, measured)` for each step of a cell, after the warm-up with `measured` true.
template <int D, class Visit>
void for_each_step(const RunCell& cell, Feed<D>& feed, Visit visit) {
  visit(feed.begin(), false);
  const std::uint64_t last = std::uint64_t{cell.warm_up} + cell.steps;
  std::vector<StepRequests<D>> block;
  for (std::uint64_t done = 0; done < last; done += block.size()) {
    block.clear();
    std::size_t bytes = 0;
    while (block.size() < kBlock && done + block.size() < last && bytes < kBlockBytes) {
      block.push_back(feed.next());
      bytes += block.back().boxes.size() * sizeof(Box<D>);
    }
    for (std::size_t k = 0; k < block.size(); ++k) visit(block[k], done + k >= cell.warm_up);
  }
}

/// No clock knows more of milliseconds than this.
double to_nanoseconds(double milliseconds) { return std::round(milliseconds * 1e6) / 1e6; }

template <int D>
Json timed_run(const RunCell& cell) {
  const auto feed = make_feed<D>(cell);
  const auto subject = feed->make_subject(cell.broad_phase);
  measure_parts(*subject);
  std::vector<double> total;
  std::vector<double> overhead;
  for_each_step<D>(cell, *feed, [&](const StepRequests<D>& requests, bool measured) {
    const SplitCost cost = costed_step(requests, *subject);
    if (!measured) return;
    total.push_back(cost.total);
    if (cost.overhead) overhead.push_back(*cost.overhead);
  });
  Json times;
  times["total_ms"] = to_nanoseconds(mean_of(total));
  times["overhead_ms"] = overhead.empty() ? Json() : Json(to_nanoseconds(mean_of(overhead)));
  times["collision_ms"] =
      overhead.empty() ? Json() : Json(to_nanoseconds(mean_of(total) - mean_of(overhead)));
  times["median_ms"] = to_nanoseconds(median(total));
  times["worst_ms"] = to_nanoseconds(std::ranges::max(total));
  return times;
}

/// Counts over the measured steps.
template <int D>
class Counts {
 public:
  explicit Counts(const RunCell& cell) {
    if (!cell.measures.errors) return;
    const std::string oracle(oracle_for(cell.options.objects, cell.broad_phase));
    oracle_ = find_algorithm<D>(oracle)->make({}, 1);
  }
  /// The requests of every step.
  void prepare(const StepRequests<D>& requests) {
    for (const Call& call : requests.calls)
      if (is_insert(call.kind))
        bodies_ += call.count;
      else if (call.kind == RequestKind::remove)
        bodies_ -= call.count;
    if (!oracle_) return;
    apply(requests, *oracle_);
    oracle_->step();
  }
  void add(const BroadPhase<D>& subject) {
    const Truth found = truth_of(subject.pairs());
    pairs_ += found.pairs;
    const std::uint64_t words[] = {found.pairs, found.checksum};
    hash_ = hash_words(words, hash_);
    structure_ = structure_of(subject);
    if (structure_.candidates) candidates_ += *structure_.candidates;
    if (!oracle_) return;
    const Difference difference =
        compare(subject.pairs(), {oracle_->pairs().begin(), oracle_->pairs().end()});
    errors_.missed += difference.missed;
    errors_.extra += difference.extra;
  }
  [[nodiscard]] Json json(const Measures& measures) const {
    Json counts{{"bodies", bodies_}, {"pairs", pairs_}, {"pairs_hash", to_hex(hash_)}};
    if (measures.counts) {
      counts["candidates"] = structure_.candidates ? Json(candidates_) : Json();
      const bool is_tree = structure_.leaves > 0;
      counts["leaves"] = is_tree ? Json(structure_.leaves) : Json();
      counts["height"] = is_tree ? Json(structure_.height) : Json();
      counts["entries"] = is_tree ? Json(structure_.entries) : Json();
      counts["operators"] = is_tree ? Json(structure_.operators) : Json();
    }
    if (!oracle_) return counts;
    counts["missed"] = errors_.missed;
    counts["extra"] = errors_.extra;
    return counts;
  }

 private:
  std::unique_ptr<BroadPhase<D>> oracle_;
  std::uint64_t bodies_ = 0;
  std::uint64_t pairs_ = 0;
  std::uint64_t hash_ = 0;
  std::uint64_t candidates_ = 0;
  Structure structure_;
  Difference errors_;
};

template <int D>
Json counted_run(const RunCell& cell) {
  const auto feed = make_feed<D>(cell);
  const auto subject = feed->make_subject(cell.broad_phase);
  Counts<D> counts(cell);
  for_each_step<D>(cell, *feed, [&](const StepRequests<D>& requests, bool measured) {
    counts.prepare(requests);
    apply(requests, *subject);
    subject->step();
    if (measured) counts.add(*subject);
  });
  return counts.json(cell.measures);
}

template <int D>
Figures measure_in(const RunCell& cell) {
  Figures figures;
  if (cell.measures.counts || cell.measures.errors) figures.counts = counted_run<D>(cell);
  if (cell.measures.times) figures.times = timed_run<D>(cell);
  return figures;
}

}  // namespace

std::string_view oracle_for(std::uint32_t objects, std::string_view broad_phase) {
  constexpr std::uint32_t kMostTested = 5000;
  if (objects <= kMostTested) return broad_phase == "all-pairs" ? "brute-force" : "all-pairs";
  return broad_phase == "sort-and-sweep" ? "columns" : "sort-and-sweep";
}

Figures measure(const RunCell& cell, const std::filesystem::path& /*folder*/, Replace /*replace*/) {
  return cell.dimension == 2 ? measure_in<2>(cell) : measure_in<3>(cell);
}

}  // namespace kerf
