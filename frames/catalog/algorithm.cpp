#include "frames/catalog/algorithm.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "core/base/assignments.h"
#include "core/base/config.h"
#include "core/broad_phase/all_pairs.h"
#include "core/broad_phase/approximate.h"
#include "core/broad_phase/brute_force.h"
#include "core/broad_phase/columns.h"
#include "core/broad_phase/loose_octree.h"
#include "core/broad_phase/sort_and_sweep.h"
#include "core/broad_phase/sweep_and_prune.h"
#include "core/bsp/bsp.h"
#include "core/related/auxiliary_planes.h"
#include "core/related/chosen_planes.h"
#include "core/related/kinetic_tree.h"
#include "core/related/multi_level_hash.h"
#include "core/related/rebuilt_tree.h"
#include "core/related/reinserting_tree.h"
#include "core/related/self_organising_tree.h"
#include "core/related/shifting_cuts.h"
#include "core/related/sphere_tree.h"
#include "frames/support/errors.h"
#include "frames/support/parse_config.h"
#include "frames/support/suggest.h"

namespace kerf {
namespace {

constexpr unsigned kMostThreads = 256;  // as many as `--threads` takes

template <int D>
Algorithm<D> tree(std::string_view name, std::string what, const Config& config) {
  return {std::string(name),
          std::move(what),
          Origin::kerf,
          kMostThreads,
          true,
          [config](const RivalHints<D>&, unsigned threads) {
            auto bsp = std::make_unique<Bsp<D>>(config);
            bsp->set_threads(threads);
            return bsp;
          }};
}

template <template <int> class Kind, int D>
Algorithm<D> own(std::string name, std::string what) {
  return {std::move(name), std::move(what), Origin::ours, 1, true, [](const RivalHints<D>&, unsigned) {
            return std::make_unique<Kind<D>>();
          }};
}

/// The related work of the paper's section 2, only by name: to be looked at and compared, not to be fast.
template <int D>
void add_related(std::vector<Algorithm<D>>& all) {
  const auto add = [&](Algorithm<D> algorithm) {
    algorithm.by_default = false;
    all.push_back(std::move(algorithm));
  };
  add(own<RebuiltTree, D>("rebuilt-tree", "a tree built from nothing in each step"));
  add(own<ReinsertingTree, D>("reinserting-tree",
                              "a static tree, what moves reinserted: Naylor; Chrysanthou, Slater"));
  add(own<AuxiliaryPlanes, D>("auxiliary-planes", "planes between groups, each with its tree: Torres"));
  add(own<ShiftingCuts, D>("shifting-cuts", "a kd-tree whose cuts follow the objects: Snyder, Lengyel"));
  add({"shifting-cuts-only", "a kd-tree whose cuts follow the objects, never built anew", Origin::ours, 1,
       false, [](const RivalHints<D>&, unsigned) { return std::make_unique<ShiftingCuts<D>>(0); }});
  add(own<SelfOrganisingTree, D>("self-organising-tree",
                                 "a tree divided only where it is used: Ar and others"));
  add(own<KineticTree, D>("kinetic-tree",
                          "a tree that changes when a prediction says so: Agarwal and others; Comba"));
  add(own<FixedDirections, D>("fixed-directions",
                              "a tree of planes from a fixed set of directions, built anew in each step"));
  add(own<PrincipalComponents, D>("principal-components",
                                  "a tree of planes by principal components: Gottschalk and others"));
  add(own<EvolvedPlanes, D>("evolved-planes", "a tree of planes by evolution: Cassen and others"));
  add(own<MultiLevelHash, D>("multi-level-hash", "hash tables of several cell sizes: Mirtich"));
  add(own<SphereTree, D>("sphere-tree", "a tree of spheres, built anew in each step: Hubbard"));
}

/// The paper's rival, only by name: where many objects move far, its swaps take quadratic time.
template <int D>
Algorithm<D> sweep_and_prune() {
  return {"sweep-and-prune",
          "our sweep-and-prune: a list an axis, ordered by swaps",
          Origin::ours,
          1,
          false,
          [](const RivalHints<D>& hints, unsigned) {
            return std::make_unique<SweepAndPrune<D>>(hints.separating);
          }};
}

template <int D>
Algorithm<D> brute_force() {
  return {"brute-force", "the oracle: each box against each",
          Origin::ours,  1,
          false,         [](const RivalHints<D>&, unsigned) { return std::make_unique<BruteForce<D>>(); }};
}

template <int D>
Algorithm<D> library(const Rival<D>& rival) {
  // Many times slower than others, or known to lose pairs that touch: only by name.
  const bool by_default = rival.name != "fcl-interval-tree" && rival.name != "fcl-spatial-hash";
  return {std::string(rival.name),
          std::string(rival.what),
          Origin::library,
          1,
          by_default,
          [make = rival.make](const RivalHints<D>& hints, unsigned) { return make(hints, Intake::checked); }};
}

template <int D>
std::optional<Algorithm<D>> find_named(std::string_view name) {
  for (Algorithm<D>& algorithm : algorithms<D>())
    if (algorithm.name == name) return std::move(algorithm);
  return std::nullopt;
}

/// The parameters behind a tree's name, split into the tree's own and those of the approximation.
struct Parameters {
  std::string config;
  std::string approximation;
};

Parameters part(std::string_view text) {
  Parameters parts;
  const std::vector<Assignment> all = parse_assignments(text, ':');
  refuse_second_values(all);
  for (const auto& [name, value] : all) {
    std::string& list = is_approximation_parameter(name) ? parts.approximation : parts.config;
    list += (list.empty() ? "" : ",") + std::string(name) + "=" + std::string(value);
  }
  return parts;
}

template <int D>
Algorithm<D> approximate(Algorithm<D> exact, const Approximation& how) {
  exact.make = [make = exact.make, how](const RivalHints<D>& hints, unsigned threads) {
    return std::make_unique<Approximate<D>>(make(hints, threads), how);
  };
  return exact;
}

}  // namespace

template <int D>
std::vector<Algorithm<D>> algorithms() {
  std::vector<Algorithm<D>> all;
  all.push_back(tree<D>(kTunedTree, "the Semi-Adjusting BSP-tree, tuned", tuned_config()));
  all.push_back(
      tree<D>(kPaperTree, "the Semi-Adjusting BSP-tree with the paper's parameters alone", Config{}));
  all.push_back(own<Columns, D>("columns", "our grid of columns, built anew in each step"));
  all.push_back(own<SortAndSweep, D>("sort-and-sweep", "our sort-and-sweep with vectors"));
  all.push_back(sweep_and_prune<D>());
  all.push_back(own<LooseOctree, D>("loose-octree", "our loose octree, built anew in each step"));
  add_related(all);
  all.push_back(own<AllPairs, D>("all-pairs", "our brute force with vectors"));
  all.push_back(brute_force<D>());
  for (const Rival<D>& rival : rivals<D>()) all.push_back(library(rival));
  return all;
}

template <int D>
std::optional<Algorithm<D>> find_algorithm(std::string_view text) try {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return find_named<D>(text);
  const std::string_view base = text.substr(0, colon);
  if (base != kTunedTree && base != kPaperTree)
    throw UsageError("'" + std::string(text) + "': only " + std::string(kTunedTree) + " and " +
                     std::string(kPaperTree) + " take parameters");
  const Parameters parts = part(text.substr(colon + 1));
  const Config config = parse_config("'" + std::string(text) + "'", parts.config,
                                     base == kTunedTree ? tuned_config() : Config{});
  Approximation how;
  kerf::apply(how, parts.approximation);
  Algorithm<D> other = tree<D>(text, "the tree with other parameters", config);
  return how == Approximation{} ? other : approximate(std::move(other), how);
} catch (const std::invalid_argument& error) {
  throw UsageError("'" + std::string(text) + "': " + error.what());
}

void check_algorithm(std::string_view text) {
  if (find_algorithm<2>(text) || find_algorithm<3>(text)) return;
  std::vector<std::string> names;
  for (const auto& algorithm : algorithms<3>()) names.push_back(algorithm.name);
  for (const auto& algorithm : algorithms<2>())
    if (std::find(names.begin(), names.end(), algorithm.name) == names.end()) names.push_back(algorithm.name);
  throw UsageError(unknown_name_message("algorithm", text, names));
}

template std::vector<Algorithm<2>> algorithms<2>();
template std::vector<Algorithm<3>> algorithms<3>();
template std::optional<Algorithm<2>> find_algorithm<2>(std::string_view);
template std::optional<Algorithm<3>> find_algorithm<3>(std::string_view);

}  // namespace kerf
