#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "core/bsp/bsp.h"
#include "core/trace/event_facts.h"
#include "tests/support/boxes.h"
#include "tests/support/config_of.h"
#include "viz/draw/frame_renderer.h"

namespace kerf::test {

/// A crowd of every shape with its tree, its pairs (every other one a contact) and one event of each
/// operator.
template <int D>
class SmallScene {
 public:
  explicit SmallScene(std::uint32_t objects = 300)
      : tree_(config_of("min_threshold=16,max_threshold=16,schedule_interval=1,budget_divisor=1,max_"
                        "redundancy=0.4,swap_share=1")) {
    Random random(5);
    for (std::uint32_t i = 0; i < objects; ++i) add(random, i);
    for (int step = 0; step < 30; ++step) {
      tree_.step();
      for (Event& event : tree_.trace().take()) {
        if (has_acted(event)) events_.push_back(event);
      }
    }
    for (std::size_t i = 0; i < tree_.pairs().size(); i += 2) contacts_.push_back(tree_.pairs()[i]);
    std::ranges::sort(contacts_);
  }

  [[nodiscard]] const Tree<D>& tree() const { return tree_.tree(); }
  [[nodiscard]] const std::vector<Body<D>>& bodies() const { return bodies_; }
  [[nodiscard]] FrameInput<D> input() const {
    return {bodies_, &tree_.tree(), tree_.pairs(), contacts_, events_, caption()};
  }

  [[nodiscard]] Caption caption() const {
    const auto objects = static_cast<std::uint32_t>(bodies_.size());
    const std::uint32_t step = events_.empty() ? 0 : events_.back().step;
    return {.scene = "small",
            .broad_phase = "kerf",
            .step = step,
            .objects = objects,
            .moving = objects,
            .pairs = tree_.pairs().size(),
            .contacts = contacts_.size(),
            .statistics = tree_.statistics()};
  }

 private:
  void add(Random& random, std::uint32_t i) {
    Body<D> body;
    const Box<D> box = random_box<D>(random, 12, 0.8);
    body.pose.position = box.center();
    body.box = box;
    body.mobility = i % 7 == 0 ? Mobility::fixed : Mobility::moving;
    const Vector<D> extent = box.extent();
    const Scalar radius = 0.5F * *std::ranges::min_element(extent.value);
    if (i % 3 == 0) {
      body.shape = Ball{radius};
    } else if (i % 3 == 1) {
      body.shape = Brick<D>{extent * 0.5F};
    } else {
      body.shape = other_shape(radius);
    }
    bodies_.push_back(body);
    EXPECT_EQ(tree_.insert(ObjectId{i}, box, body.mobility), Status::ok);
  }

  static Shape<D> other_shape(Scalar radius) {
    if constexpr (D == 2) {
      return Outline{{{{-radius, -radius}}, {{radius, -radius}}, {{0, radius}}}};
    } else {
      Surface surface;
      surface.vertices = {{{-radius, 0, -radius}}, {{radius, 0, -radius}}, {{0, radius, radius}}};
      surface.triangles = {{0, 2, 1}};
      return std::make_shared<const Surface>(surface);
    }
  }

  Bsp<D, EventLog> tree_;
  std::vector<Body<D>> bodies_;
  std::vector<Pair> contacts_;
  std::vector<Event> events_;
};

}  // namespace kerf::test
