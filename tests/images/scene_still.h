#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "core/bsp/bsp.h"
#include "core/trace/event_facts.h"
#include "frames/catalog/scene_catalog.h"
#include "tests/support/config_of.h"
#include "viz/draw/frame_renderer.h"

namespace kerf::test {

/// A small scene of the catalog after so many steps, with a tree that is worth seeing.
template <int D>
class SceneStill {
 public:
  explicit SceneStill(const std::string& name, std::uint32_t objects = 140, std::uint32_t steps = 60)
      : name_(name),
        tree_(config_of("min_threshold=12,max_threshold=24,schedule_interval=4,budget_divisor=2,"
                        "max_redundancy=0.3,swap_share=1")) {
    const auto* entry = std::get<const SceneEntry<D>*>(find_scene(name).entry);
    SceneOptions options;
    options.objects = objects;
    if (entry->grows) options.steps = steps - 10;
    scene_ = entry->make(tree_, options);
    while (scene_->step() < steps) {
      scene_->advance();
      for (Event& event : tree_.trace().take())
        if (has_acted(event)) events_.push_back(event);
    }
  }

  [[nodiscard]] FrameInput<D> input() const {
    FrameInput<D> input{.bodies = scene_->bodies(),
                        .tree = &tree_.tree(),
                        .pairs = scene_->pairs(),
                        .contacts = scene_->contacts(),
                        .events = events_,
                        .caption = {}};
    input.caption.scene = name_;
    input.caption.broad_phase = "kerf-paper";
    input.caption.step = scene_->step();
    input.caption.objects = static_cast<std::uint32_t>(scene_->bodies().size());
    input.caption.moving = input.caption.objects;
    input.caption.pairs = scene_->pairs().size();
    input.caption.contacts = scene_->contacts().size();
    input.caption.statistics = tree_.statistics();
    return input;
  }

 private:
  std::string name_;
  Bsp<D, EventLog> tree_;
  std::unique_ptr<Scene<D>> scene_;
  std::vector<Event> events_;
};

}  // namespace kerf::test
