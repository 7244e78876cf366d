#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "core/objects/broad_phase.h"
#include "core/objects/object_table.h"
#include "core/recording/recording_info.h"
#include "core/recording/step_requests.h"

namespace kerf {

/// The wall time since a moment, in nanoseconds.
inline double nanoseconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count();
}

/// Nanoseconds that a broad phase takes for all requests of a step and the step itself.
template <int D>
double timed_step(const StepRequests<D>& requests, BroadPhase<D>& broad_phase) {
  const auto start = std::chrono::steady_clock::now();
  apply(requests, broad_phase);
  broad_phase.step();
  return nanoseconds_since(start);
}

/// A step as a broad phase saw it in a simulation.
template <int D>
struct WatchedStep {
  StepRequests<D> requests;
  std::uint64_t pairs_hash = 0;
  double loop_ns = 0;  ///< what the broad phase took in the simulation
};

/// Stands between a scene and its broad phase, measures the broad phase and keeps its requests, so that
/// another one can be given the same. Requests reach the broad phase at the beginning of the step.
template <int D>
class LoopWatch final : public BroadPhase<D> {
 public:
  /// `not_counted` returns the seconds so far that were spent within the broad phase but are not its own (a
  /// recorder's).
  LoopWatch(BroadPhase<D>& inner, std::function<double()> not_counted)
      : inner_(inner), not_counted_(std::move(not_counted)), table_(inner.volume_kind()) {}

  [[nodiscard]] std::string_view name() const override { return inner_.name(); }
  [[nodiscard]] VolumeKind volume_kind() const override { return inner_.volume_kind(); }
  Status insert(ObjectId object, const Box<D>& box, Mobility mobility) override {
    requests_.add_insert(object, box, mobility);
    return table_.insert(object, box, mobility);
  }
  Status insert(ObjectId object, const Volume<D>& volume, Mobility mobility) override {
    if (volume.kind == VolumeKind::box) return insert(object, volume.box, mobility);
    requests_.add_insert(object, volume, mobility);
    return table_.insert(object, volume, mobility);
  }
  Status move(ObjectId object, const Box<D>& box) override { return move_many({&object, 1}, {&box, 1}); }
  Status move(ObjectId object, const Volume<D>& volume) override {
    if (volume.kind == VolumeKind::box) return move(object, volume.box);
    requests_.add_move(object, volume);
    return table_.move(object, volume);
  }
  Status move_many(std::span<const ObjectId> objects, std::span<const Box<D>> boxes) override {
    requests_.add_moves(objects, boxes);
    Status first = Status::ok;
    for (std::size_t k = 0; k < objects.size(); ++k) {
      const Status status = table_.move(objects[k], boxes[k]);
      if (first == Status::ok) first = status;
    }
    return first;
  }
  Status remove(ObjectId object) override {
    requests_.add_remove(object);
    return table_.remove(object);
  }
  void step() override {
    const auto start = std::chrono::steady_clock::now();
    const double before = not_counted_();
    double spent = timed_step(requests_, inner_);
    spent -= (not_counted_() - before) * 1e9;
    steps_.push_back({std::exchange(requests_, {}), hash_pairs(inner_.pairs()), spent});
    watching_ns_ += nanoseconds_since(start) - spent;
  }
  [[nodiscard]] std::span<const Pair> pairs() const override { return inner_.pairs(); }

  /// The steps since the last call.
  std::vector<WatchedStep<D>> take() { return std::exchange(steps_, {}); }
  /// What watching, and all that is not counted, took within `step()` so far.
  [[nodiscard]] double watching_ns() const { return watching_ns_; }

 private:
  BroadPhase<D>& inner_;
  std::function<double()> not_counted_;
  ObjectTable<D> table_;  ///< answers requests as the broad phase will
  StepRequests<D> requests_;
  std::vector<WatchedStep<D>> steps_;
  double watching_ns_ = 0;
};

}  // namespace kerf
