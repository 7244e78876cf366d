#include "core/replay/replayer.h"

#include <iterator>
#include <utility>

#include "core/base/float_mode.h"

namespace kerf {
namespace {

/// The approximate memory of a state.
template <int D>
std::size_t size_of(const BspState<D>& state) {
  constexpr std::size_t kObject = 2 * (sizeof(PackedBox<D>) + 2) + sizeof(Skin) + 1;
  return state.tree.entries() * sizeof(Entry) + state.tree.slots() * sizeof(Node<D>) +
         state.latest.bound() * kObject + state.pairs.size() * sizeof(Pair);
}

}  // namespace

template <int D>
void run_recorded_step(RecordingReader<D>& recording, Bsp<D, Watch>& tree, bool swept) {
  const std::uint32_t next = tree.steps() + 1;
  apply(recording.step(next).requests, tree);
  if (!recording.info().changes.empty()) tree.set_config(config_of(recording.info(), next));
  if (swept) {
    tree.step();
  } else {
    tree.step_unswept();
  }
}

template <int D>
Replayer<D>::Replayer(std::shared_ptr<RecordingReader<D>> recording, std::size_t memory)
    : recording_(std::move(recording)),
      memory_(memory),
      tree_(recording_->info().config, recording_->info().volume) {
  tree_.decide(recording_->info().decisions);
  keep();  // step 0, which has no pairs
}

template <int D>
void Replayer<D>::seek(std::uint32_t step) {
  const DefaultFloats floats;
  if (step > recording_->steps()) (void)recording_->step(step);  // throws, naming the steps that exist
  if (step != this->step() || !swept_) start_before(step);
  while (this->step() < step) {
    run_next(this->step() + 1 == step);
    keep();
  }
}

/// Restores the latest state that leads to the step: the present one, a kept one, or a keyframe. A state
/// without the pairs of its own step, such as a keyframe, leads only to later steps.
template <int D>
void Replayer<D>::start_before(std::uint32_t step) {
  const std::uint32_t keyframe = step == 0 ? 0 : recording_->keyframe_before(step - 1);
  auto kept = std::prev(kept_.upper_bound(step));  // step 0 is always kept
  if (kept->first == step && !kept->second.swept) --kept;
  const bool has_kept = kept->first >= keyframe;
  const std::uint32_t best = has_kept ? kept->first : keyframe;
  const bool is_on_the_way = this->step() < step || (this->step() == step && swept_);
  if (is_on_the_way && this->step() >= best) return;
  if (has_kept) {
    tree_.restore(kept->second.state);
  } else {
    tree_.restore(recording_->keyframe(keyframe, tree_.tree().projector()));
  }
  swept_ = has_kept && kept->second.swept;
}

template <int D>
void Replayer<D>::advance(const OnEvent& on_event) {
  const DefaultFloats floats;
  tree_.trace().on_event = on_event;
  run_next(true);
  tree_.trace().on_event = {};
}

template <int D>
void Replayer<D>::run_next(bool swept) {
  run_recorded_step(*recording_, tree_, swept);
  swept_ = swept;
}

template <int D>
void Replayer<D>::keep() {
  const auto known = kept_.find(step());
  if (known != kept_.end()) {
    if (known->second.swept || !swept_) return;
    kept_bytes_ -= known->second.bytes;
    kept_.erase(known);
  }
  Kept kept{tree_.state(), 0, swept_};
  kept.bytes = size_of(kept.state);
  kept_bytes_ += kept.bytes;
  kept_.emplace(step(), std::move(kept));
  while (kept_bytes_ > memory_ && kept_.size() > 2) forget_farthest(step());
}

/// Keeps the state before the first step: no keyframe has it.
template <int D>
void Replayer<D>::forget_farthest(std::uint32_t from) {
  const auto first = std::next(kept_.begin());
  const auto last = std::prev(kept_.end());
  const auto farthest = from - first->first > last->first - from ? first : last;
  kept_bytes_ -= farthest->second.bytes;
  kept_.erase(farthest);
}

template void run_recorded_step<2>(RecordingReader<2>&, Bsp<2, Watch>&, bool);
template void run_recorded_step<3>(RecordingReader<3>&, Bsp<3, Watch>&, bool);
template class Replayer<2>;
template class Replayer<3>;

}  // namespace kerf
