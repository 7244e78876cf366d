#include "frames/catalog/broad_phase_choice.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "frames/catalog/scene_catalog.h"
#include "frames/support/errors.h"
#include "tests/frames/program.h"

namespace kerf {
namespace {

template <int D>
const SceneEntry<D>& entry_of(std::string_view name) {
  static const std::vector<CatalogScene> catalog = scene_catalog();
  for (const CatalogScene& scene : catalog)
    if (scene.name == name) return *std::get<const SceneEntry<D>*>(scene.entry);
  throw std::logic_error("no such scene");
}

/// A run of a scene: where everything was in each step, and what touched.
template <int D>
struct Run {
  std::vector<Vector<D>> positions;
  std::vector<Pair> contacts;
  friend bool operator==(const Run&, const Run&) = default;
};

template <int D>
Run<D> run(const SceneEntry<D>& entry, std::string_view broad_phase) {
  constexpr SceneOptions kOptions{.objects = 150, .steps = 60, .seed = 4};
  BroadPhaseChoice choice = choose_broad_phase(broad_phase, entry.needs);
  choice.volume = VolumeKind::box;
  const auto subject = make_broad_phase<D>(choice, entry, kOptions);
  const auto scene = entry.make(*subject, kOptions);
  Run<D> run;
  for (int step = 0; step < 120; ++step) {
    scene->advance();
    for (const Body<D>& body : scene->bodies()) run.positions.push_back(body.pose.position);
    run.contacts.insert(run.contacts.end(), scene->contacts().begin(), scene->contacts().end());
  }
  return run;
}

template <int D>
void all_exact_broad_phases_give_one_run(std::string_view scene) {
  const SceneEntry<D>& entry = entry_of<D>(scene);
  const Run<D> reference = run(entry, "brute-force");
  EXPECT_GT(reference.contacts.size(), 1000U);
  for (const std::string& name : broad_phase_names<D>()) {
    if (name == "ode-hash") continue;  // not exact, see `broad_phase_names`
    EXPECT_TRUE(run(entry, name) == reference) << name;
  }
}

TEST(BroadPhaseChoice, AllExactOnesGiveTheSameRunIn2D) { all_exact_broad_phases_give_one_run<2>("pile"); }

TEST(BroadPhaseChoice, AllExactOnesGiveTheSameRunIn3D) { all_exact_broad_phases_give_one_run<3>("terrain"); }

TEST(BroadPhaseChoice, TreesComeWithTheirParameters) {
  const Needs needs{.volume = VolumeKind::oriented_box, .free_directions = false};
  const BroadPhaseChoice paper = choose_broad_phase("kerf-paper", needs);
  EXPECT_EQ(to_string(paper.config), to_string(default_config(needs)));
  EXPECT_EQ(paper.volume, VolumeKind::oriented_box);
  EXPECT_EQ(to_string(choose_broad_phase("kerf", needs).config), to_string(tuned_config()));
  EXPECT_EQ(choose_broad_phase("brute-force", needs).volume, VolumeKind::oriented_box);
  EXPECT_EQ(choose_broad_phase("ode-hash", needs).volume, VolumeKind::box) << "it knows nothing else";
}

TEST(BroadPhaseChoice, RendersWithoutATree) {
  const test::TemporaryFolder folder;
  const test::RunOutcome outcome =
      test::run_kerf({"render", "buckets", "--steps", "1:61:30", "--objects", "60", "--grow", "10", "--size",
                      "160x120", "--broad-phase", "ode-quadtree", "--out", (folder.path() / "f").string()});
  ASSERT_EQ(outcome.exit, kExitHolds) << outcome.err;
  const auto manifest = test::read_json(folder.path() / "f" / "frames.json");
  EXPECT_EQ(manifest["broad_phase"], "ode-quadtree");
  EXPECT_TRUE(manifest["config"].is_null());
  EXPECT_EQ(manifest["frames"].size(), 3U);
  EXPECT_GT(manifest["frames"][2]["pairs"], 0);
}

}  // namespace
}  // namespace kerf
