#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/config.h"
#include "core/objects/broad_phase.h"
#include "core/scene/scene.h"
#include "frames/catalog/algorithm.h"

namespace kerf {

/// What is to find a scene's pairs. `config` concerns the trees only, `volume` them and the oracle.
struct BroadPhaseChoice {
  std::string name{kPaperTree};
  Config config;
  VolumeKind volume = VolumeKind::box;

  [[nodiscard]] bool is_tree() const { return name == kTunedTree || name == kPaperTree; }
};

/// The names of all broad phases that a scene of D dimensions can have: those of `algorithms<D>()` but for
/// three of FCL's. One crashes when objects come a few at a time, two miss pairs (docs/HARD_CASES.md); `kerf
/// bench` measures them in processes of their own. All others are exact but "ode-hash", which misses a pair
/// now and then.
template <int D>
std::vector<std::string> broad_phase_names();

/// The choice called `name`, with the parameters and the volume that such a scene asks for: the tuned ones
/// for "kerf", the paper's without what the scene does not need for "kerf-paper"; boxes for whoever knows
/// nothing else. Throws UsageError, with a suggestion, unless there is such a broad phase in the scene's
/// dimension.
BroadPhaseChoice choose_broad_phase(std::string_view name, const Needs& needs);

/// Whether it can be given other volumes than boxes.
bool takes_volumes(std::string_view name);

/// An empty broad phase for that scene. Libraries that must know beforehand where objects will be are told
/// by a second world, built for that and thrown away.
template <int D>
std::unique_ptr<BroadPhase<D>> make_broad_phase(const BroadPhaseChoice& choice, const SceneEntry<D>& scene,
                                                const SceneOptions& options);

}  // namespace kerf
