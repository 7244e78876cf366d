#include "frames/catalog/broad_phase_choice.h"

#include <algorithm>
#include <array>

#include "core/broad_phase/brute_force.h"
#include "core/bsp/bsp.h"
#include "frames/support/errors.h"
#include "frames/support/parse_config.h"
#include "frames/support/suggest.h"

namespace kerf {
namespace {

constexpr std::string_view kOracle = "brute-force";

template <int D>
void check_name(std::string_view name, std::string_view option) {
  const std::vector<std::string> names = broad_phase_names<D>();
  if (std::ranges::find(names, name) != names.end()) return;
  throw UsageError(std::string(option) + ": " +
                   unknown_name_message(std::to_string(D) + "D broad phase", name, names));
}

/// The bounds of the objects in the first step, with room for those that come, fly and fall.
template <int D>
RivalHints<D> hints_for(const SceneEntry<D>& entry, const SceneOptions& options) {
  constexpr Scalar kRoom = 0.25F;
  constexpr std::uint32_t kSpare = 1024;
  BruteForce<D> broad_phase;
  const auto scene = entry.make(broad_phase, options);
  scene->advance();
  RivalHints<D> hints;
  hints.bounds = Box<D>::empty();
  for (const Body<D>& body : scene->bodies()) hints.bounds = join(hints.bounds, body.box);
  const Vector<D> room = hints.bounds.extent() * kRoom;
  hints.bounds = {hints.bounds.min - room, hints.bounds.max + room};
  hints.box_size = 1;
  const std::uint32_t moving = options.objects == 0 ? entry.default_objects : options.objects;
  hints.capacity = static_cast<std::uint32_t>(scene->bodies().size()) + moving + kSpare;
  hints.separating = entry.needs.separating;
  return hints;
}

}  // namespace

template <int D>
std::vector<std::string> broad_phase_names() {
  constexpr std::array<std::string_view, 3> kFaulty{"fcl-sap", "fcl-interval-tree", "fcl-spatial-hash"};
  std::vector<std::string> names;
  for (const Algorithm<D>& algorithm : algorithms<D>())
    if (std::ranges::find(kFaulty, algorithm.name) == kFaulty.end()) names.push_back(algorithm.name);
  return names;
}

bool takes_volumes(std::string_view name) {
  return name == kTunedTree || name == kPaperTree || name == kOracle;
}

BroadPhaseChoice choose_broad_phase(std::string_view name, const Needs& needs, std::string_view option) {
  if (needs.dimension == 2) {
    check_name<2>(name, option);
  } else {
    check_name<3>(name, option);
  }
  BroadPhaseChoice choice;
  choice.name = name;
  choice.config = name == kTunedTree ? tuned_config() : default_config(needs);
  if (takes_volumes(name)) choice.volume = needs.volume;
  return choice;
}

BroadPhaseChoice choose_with_parameters(std::string_view text, const Needs& needs, std::string_view option) {
  const std::size_t colon = text.find(':');
  BroadPhaseChoice choice = choose_broad_phase(text.substr(0, colon), needs, option);
  if (colon == std::string_view::npos) return choice;
  const std::string whole = std::string(option) + " '" + std::string(text) + "'";
  if (!choice.is_tree())
    throw UsageError(whole + ": only " + std::string(kTunedTree) + " and " + std::string(kPaperTree) +
                     " take parameters");
  std::string parameters(text.substr(colon + 1));
  std::ranges::replace(parameters, ':', ',');
  choice.config = parse_config(whole, parameters, choice.config);
  return choice;
}

template <int D>
std::unique_ptr<BroadPhase<D>> make_broad_phase(const BroadPhaseChoice& choice, const SceneEntry<D>& scene,
                                                const SceneOptions& options) {
  const bool needs_hints = !choice.is_tree() && choice.name != kOracle;
  return make_broad_phase<D>(choice, needs_hints ? hints_for(scene, options) : RivalHints<D>{});
}

template <int D>
std::unique_ptr<BroadPhase<D>> make_broad_phase(const BroadPhaseChoice& choice, const RivalHints<D>& hints) {
  if (choice.is_tree()) return std::make_unique<Bsp<D>>(choice.config, choice.volume);
  if (choice.name == kOracle) return std::make_unique<BruteForce<D>>(choice.volume);
  check_name<D>(choice.name, "--broad-phase");
  return find_algorithm<D>(choice.name)->make(hints, 1);
}

template std::vector<std::string> broad_phase_names<2>();
template std::vector<std::string> broad_phase_names<3>();
template std::unique_ptr<BroadPhase<2>> make_broad_phase(const BroadPhaseChoice&, const SceneEntry<2>&,
                                                         const SceneOptions&);
template std::unique_ptr<BroadPhase<3>> make_broad_phase(const BroadPhaseChoice&, const SceneEntry<3>&,
                                                         const SceneOptions&);
template std::unique_ptr<BroadPhase<2>> make_broad_phase(const BroadPhaseChoice&, const RivalHints<2>&);
template std::unique_ptr<BroadPhase<3>> make_broad_phase(const BroadPhaseChoice&, const RivalHints<3>&);

}  // namespace kerf
