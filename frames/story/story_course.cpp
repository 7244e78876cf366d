#include "frames/story/story_course.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>

#include "core/broad_phase/loose_octree.h"
#include "core/broad_phase/sweep_and_prune.h"
#include "core/replay/replayer.h"
#include "core/trace/event_facts.h"
#include "frames/bench/structure.h"
#include "frames/sequence/recording_file.h"
#include "viz/draw/palette.h"

namespace kerf {
namespace {

template <int D>
std::unique_ptr<BroadPhase<D>> make_beside(const std::string& name) {
  if (name == "loose-octree") return std::make_unique<LooseOctree<D>>();
  if (name == "sweep-and-prune") return std::make_unique<SweepAndPrune<D>>();
  return nullptr;
}

double pairs_among(double objects) { return 0.5 * objects * (objects - 1); }

/// The tuned tree keeps no ordered lists: then all pairs that share a leaf.
template <int D>
double tests_in(const Bsp<D, Watch>& tree) {
  if (!tree.config().byte_sweep) return static_cast<double>(list_candidates(tree.tree()));
  double tests = 0;
  for_each_node(tree.tree(), tree.tree().root(), [&](NodeId id) {
    const Node<D>& node = tree.tree()[id];
    if (node.is_leaf()) tests += pairs_among(static_cast<double>(node.entries.size()));
  });
  return tests;
}

template <int D>
StoryCourse follow(std::shared_ptr<RecordingReader<D>> recording, const StepRange& steps,
                   const std::string& beside, const std::function<bool(std::uint32_t)>& go_on) {
  const bool is_tuned = recording->info().config.byte_sweep;
  StoryCourse course;
  course.names = recording->info().names;
  course.curves = {{"each with each", palette::kSeries[6], {}},
                   {beside, palette::kSeries[1], {}},
                   {is_tuned ? "our tree: in one leaf" : "our tree", palette::kSeries[0], {}}};
  const auto other = make_beside<D>(beside);
  Replayer<D> replayer(recording, 0);
  for (std::uint32_t step = 1; step <= steps.last && go_on(step); ++step) {
    replayer.advance();
    const RecordedStep<D>& recorded = recording->step(step);
    if (other) {
      apply(recorded.requests, *other);
      other->step();
    }
    const Statistics statistics = replayer.tree().statistics();
    course.levels = std::max(course.levels, statistics.height + 1);
    const auto candidates = other ? candidates_of(*other) : std::nullopt;
    course.curves[0].values.push_back(static_cast<float>(pairs_among(statistics.objects)));
    course.curves[1].values.push_back(candidates ? static_cast<float>(*candidates) : -1.0F);
    course.curves[2].values.push_back(static_cast<float>(tests_in(replayer.tree())));
    if (step < steps.first) continue;
    for (const Event& event : recorded.events)
      if (const auto* const acted = acted_of(event)) course.operators.push_back({step, event.id, *acted});
  }
  if (!other) course.curves.erase(course.curves.begin() + 1);
  return course;
}

std::uint32_t size_of_moment(const StoryMoment& moment) {
  return std::max(moment.acted.before.population, moment.acted.after.population);
}

}  // namespace

StoryCourse follow_course(const std::filesystem::path& recording, const StepRange& steps,
                          const std::string& beside, const std::function<bool(std::uint32_t)>& go_on) {
  return with_recording(recording, [&](const auto& reader) { return follow(reader, steps, beside, go_on); });
}

std::vector<std::string> broad_phases_beside() { return {"loose-octree", "sweep-and-prune", "none"}; }

std::vector<StoryMoment> choose_moments(const std::vector<StoryMoment>& operators, const StepRange& steps,
                                        std::size_t count) {
  std::vector<const StoryMoment*> by_size;
  for (const StoryMoment& moment : operators) by_size.push_back(&moment);
  std::ranges::stable_sort(by_size, std::ranges::greater(),
                           [](const auto* moment) { return size_of_moment(*moment); });
  const double share =
      (steps.last - steps.first) / (2.0 * static_cast<double>(std::max<std::size_t>(1, count)));
  std::vector<StoryMoment> chosen;
  const auto has_room = [&](const StoryMoment& moment) {
    return std::ranges::none_of(chosen, [&](const StoryMoment& other) {
      return std::abs(double{1} * other.step - moment.step) < std::max(1.0, share);
    });
  };
  std::array<bool, kOperatorCount> seen{};
  for (const bool is_first_round : {true, false})
    for (const StoryMoment* const moment : by_size) {
      bool& is_seen = seen[static_cast<std::size_t>(moment->acted.op)];
      if (chosen.size() >= count || (is_first_round && is_seen) || !has_room(*moment)) continue;
      is_seen = true;
      chosen.push_back(*moment);
    }
  std::ranges::sort(chosen, {}, &StoryMoment::step);
  return chosen;
}

}  // namespace kerf
