#include "core/bsp/bsp_state.h"

#include <algorithm>

#include "core/bsp/bsp.h"

namespace kerf {

template <int D, class Trace>
BspState<D> Bsp<D, Trace>::state() const {
  return {config_,
          tree_,
          scheduler_,
          objects(),
          skins_,
          {pairs().begin(), pairs().end()},
          static_cast<std::uint8_t>(mode_),
          keep_or_sweep_,
          placed_,
          reporter_.next_id(),
          step_};
}

template <int D, class Trace>
void Bsp<D, Trace>::restore(const BspState<D>& state) {
  config_ = state.config;
  tree_ = state.tree;
  scheduler_ = state.scheduler;
  latest_ = state.latest;
  exchange_.forget();
  skins_ = state.skins;
  mode_ = static_cast<Mode>(state.mode);
  if (mode_ == Mode::kept)  // a damaged recording may have too few skins
    skins_.resize(std::max(skins_.size(), latest_.bound()));
  keep_or_sweep_ = state.keep_or_sweep;
  placed_ = state.placed;
  step_ = state.step;
  reporter_.resume(state.next_event, state.step);
  kept_.clear();
  changed_.clear();
  before_.clear();
  only_moves_ = true;
  attention_.resize(latest_.bound());
  for (std::uint32_t id = 0; id < latest_.bound(); ++id) attention_[id] = attention_at_rest({id});
  pairs_.clear();
  pairs_.append(state.pairs);
}

#define KERF_INSTANTIATE(D, TRACE)                   \
  template BspState<D> Bsp<D, TRACE>::state() const; \
  template void Bsp<D, TRACE>::restore(const BspState<D>&);
KERF_FOR_EACH_TRACE(KERF_INSTANTIATE)
#undef KERF_INSTANTIATE

}  // namespace kerf
