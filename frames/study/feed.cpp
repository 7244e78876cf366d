#include "frames/study/feed.h"

#include <utility>

#include "core/bsp/bsp.h"
#include "frames/bench/loop_watch.h"
#include "frames/catalog/algorithm.h"
#include "frames/catalog/broad_phase_choice.h"

namespace kerf {
namespace {

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

}  // namespace

template <int D>
std::unique_ptr<Feed<D>> make_feed(const RunCell& cell) {
  return std::visit([&](const auto& scene) { return feed_of<D>(scene, cell.options); }, cell.scene);
}

template std::unique_ptr<Feed<2>> make_feed(const RunCell&);
template std::unique_ptr<Feed<3>> make_feed(const RunCell&);

}  // namespace kerf
