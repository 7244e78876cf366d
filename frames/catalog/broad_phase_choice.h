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

/// The broad phase for a scene. `config` is for the trees only, `volume` for the trees and the oracle.
struct BroadPhaseChoice {
  std::string name{kPaperTree};
  Config config;
  VolumeKind volume = VolumeKind::box;

  [[nodiscard]] bool is_tree() const { return name == kTunedTree || name == kPaperTree; }
};

/// The names of all broad phases for a scene of D dimensions: those of `algorithms<D>()` except three of
/// FCL's. One crashes when objects come a few at a time, two miss pairs (docs/HARD_CASES.md); `kerf bench`
/// measures them in processes of their own. All others are exact except "ode-hash", which rarely misses a
/// pair.
template <int D>
std::vector<std::string> broad_phase_names();

/// The choice called `name`, with parameters and volume for such a scene: the tuned parameters for "kerf",
/// for "kerf-paper" the paper's, without what the scene does not need; boxes for a broad phase that takes
/// nothing else. Throws UsageError for `option`, with a suggestion, unless the scene's dimension has such a
/// broad phase.
BroadPhaseChoice choose_broad_phase(std::string_view name, const Needs& needs,
                                    std::string_view option = "--broad-phase");

/// The same, where parameters may stand behind the name of a tree: "kerf:K=V:K=V".
BroadPhaseChoice choose_with_parameters(std::string_view text, const Needs& needs,
                                        std::string_view option = "--broad-phase");

/// Whether it accepts other volumes than boxes.
bool takes_volumes(std::string_view name);

/// An empty broad phase for that scene. Libraries that must know the bounds beforehand get them from a second
/// world, built for that and thrown away.
template <int D>
std::unique_ptr<BroadPhase<D>> make_broad_phase(const BroadPhaseChoice& choice, const SceneEntry<D>& scene,
                                                const SceneOptions& options);
/// The same where the boxes are known beforehand.
template <int D>
std::unique_ptr<BroadPhase<D>> make_broad_phase(const BroadPhaseChoice& choice, const RivalHints<D>& hints);

}  // namespace kerf
