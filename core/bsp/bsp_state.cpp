#include "core/bsp/bsp_state.h"

#include "core/bsp/bsp.h"

namespace kerf {

template <int D, class Trace>
BspState<D> Bsp<D, Trace>::state() const {
  return {config_, tree_,   scheduler_,          objects(), kept_.skins(), {pairs().begin(), pairs().end()},
          modes_,  placed_, reporter_.next_id(), step_};
}

template <int D, class Trace>
void Bsp<D, Trace>::restore(const BspState<D>& state) {
  config_ = state.config;
  tree_ = state.tree;
  scheduler_ = state.scheduler;
  modes_ = state.modes;
  const bool keeps = modes_.mode() == Mode::kept;
  kept_.restore(state.skins, keeps ? state.latest.bound() : 0);
  requests_.restore(state.latest, keeps ? kept_.skins() : std::span<const Skin>{});
  placed_ = state.placed;
  step_ = state.step;
  reporter_.resume(state.next_event, state.step);
  swept_.forget_pairs();
  pairs_.clear();
  pairs_.append(state.pairs);
}

#define KERF_INSTANTIATE(D, TRACE)                   \
  template BspState<D> Bsp<D, TRACE>::state() const; \
  template void Bsp<D, TRACE>::restore(const BspState<D>&);
KERF_FOR_EACH_TRACE(KERF_INSTANTIATE)
#undef KERF_INSTANTIATE

}  // namespace kerf
