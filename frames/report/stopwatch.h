#pragma once

#include <memory>
#include <utility>

#include "core/objects/broad_phase.h"
#include "frames/rivals/step_timer.h"

namespace kerf {

/// A broad phase that measures the time of its `step()`.
template <int D>
class Stopwatch final : public BroadPhase<D> {
 public:
  explicit Stopwatch(std::unique_ptr<BroadPhase<D>> inner) : inner_(std::move(inner)) {}

  [[nodiscard]] std::string_view name() const override { return inner_->name(); }
  using BroadPhase<D>::insert;
  using BroadPhase<D>::move;
  Status insert(ObjectId object, const Box<D>& box, Mobility mobility) override {
    return inner_->insert(object, box, mobility);
  }
  Status move(ObjectId object, const Box<D>& box) override { return inner_->move(object, box); }
  Status move_many(std::span<const ObjectId> objects, std::span<const Box<D>> boxes) override {
    return inner_->move_many(objects, boxes);
  }
  Status remove(ObjectId object) override { return inner_->remove(object); }
  void step() override {
    const StepTimer timer(true);
    inner_->step();
    nanoseconds_ = static_cast<double>(timer.nanoseconds());
  }
  [[nodiscard]] std::span<const Pair> pairs() const override { return inner_->pairs(); }
  /// Of the last step.
  [[nodiscard]] double nanoseconds() const { return nanoseconds_; }

 private:
  std::unique_ptr<BroadPhase<D>> inner_;
  double nanoseconds_ = 0;
};

}  // namespace kerf
