#pragma once

#include <algorithm>
#include <vector>

#include "core/bsp/bsp.h"
#include "core/scene/scene.h"
#include "tests/support/checked.h"

namespace kerf::test {

/// A tree with the paper's parameters, as far as the scene needs them, and one with all policies beyond it.
template <int D>
std::vector<Config> configs_for(const SceneEntry<D>& entry) {
  return {default_config(entry.needs), tuned_config()};
}

/// Runs a scene with a tree beside the oracle, by the volumes that the scene needs.
template <int D>
void expect_the_oracles_pairs(const SceneEntry<D>& entry, const SceneOptions& options, int steps) {
  for (const Config& config : configs_for(entry)) {
    Bsp<D> tree(config, entry.needs.volume);
    Checked<D> checked(tree);
    const auto scene = entry.make(checked, options);
    std::size_t pairs = 0;
    std::vector<Box<D>> before;
    std::size_t moved = 0;
    for (int step = 0; step < steps && !testing::Test::HasFailure(); ++step) {
      scene->advance();
      pairs += scene->pairs().size();
      for (std::size_t k = 0; k < before.size(); ++k) moved += scene->bodies()[k].box == before[k] ? 0U : 1U;
      before.clear();
      for (const Body<D>& body : scene->bodies()) before.push_back(body.box);
    }
    EXPECT_GT(pairs, 1000U) << "too few pairs for the test to mean anything";
    EXPECT_GT(moved, 1000U) << "nothing moves";
  }
}

/// Whether two broad phases lead to the same run: where everything is and what touches, in each step.
template <int D>
bool same_runs(const SceneEntry<D>& entry, const SceneOptions& options, int steps, BroadPhase<D>& a,
               BroadPhase<D>& b) {
  const auto one = entry.make(a, options);
  const auto other = entry.make(b, options);
  for (int step = 0; step < steps; ++step) {
    one->advance();
    other->advance();
    const bool same =
        std::ranges::equal(one->bodies(), other->bodies(), [](const Body<D>& x, const Body<D>& y) {
          return x.pose.position == y.pose.position && x.pose.axes == y.pose.axes && x.box == y.box;
        });
    if (!same || !std::ranges::equal(one->contacts(), other->contacts())) return false;
  }
  return true;
}

/// What a scene states of itself must hold from the first step on.
template <int D>
void expect_needs_hold(const SceneEntry<D>& entry) {
  BruteForce<D> broad_phase(entry.needs.volume);
  const auto scene = entry.make(broad_phase, {.objects = 100, .steps = 10});
  EXPECT_EQ(describe(scene->needs()), describe(entry.needs));
  EXPECT_EQ(entry.needs.dimension, D);
  EXPECT_FALSE(entry.summary.empty());
  EXPECT_FALSE(entry.source.empty());
  EXPECT_TRUE(entry.grows || !entry.parameters.empty());
  for (int step = 0; step < 40; ++step) scene->advance();
  const auto fixed = [](const Body<D>& body) { return body.mobility == Mobility::fixed; };
  EXPECT_EQ(std::ranges::any_of(scene->bodies(), fixed), entry.needs.fixed_objects);
  EXPECT_FALSE(scene->contacts().empty() && entry.name != "fracture");
}

/// How many pairs of entries overlap along their leaf's ordered list, over some steps: what a tree of that
/// configuration leaves to be tested.
template <int D>
double candidates_of(const SceneEntry<D>& entry, const SceneOptions& options, int steps,
                     const Config& config) {
  Bsp<D> tree(config, entry.needs.volume);
  const auto scene = entry.make(tree, options);
  double count = 0;
  for (int step = 0; step < steps; ++step) {
    scene->advance();
    for_each_node(tree.tree(), tree.tree().root(), [&](NodeId id) {
      const std::vector<Entry>& entries = tree.tree()[id].entries;
      for (std::size_t i = 0; i < entries.size(); ++i)
        for (std::size_t k = i + 1; k < entries.size() && entries[k].key.lo <= entries[i].key.hi; ++k)
          ++count;
    });
  }
  return count;
}

}  // namespace kerf::test
