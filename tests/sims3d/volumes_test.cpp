#include <gtest/gtest.h>

#include <vector>

#include "core/bsp/bsp.h"
#include "core/scene/bounding.h"
#include "sims3d/scenes/scenes.h"

namespace kerf::test {
namespace {

/// Where every body is after some steps of a scene, and what touches.
struct RunOutcome {
  std::vector<Vector<3>> positions;
  std::vector<Pair> contacts;
  std::size_t pairs = 0;  ///< in all steps
  std::size_t met = 0;    ///< contacts in all steps
  friend bool operator==(const RunOutcome& a, const RunOutcome& b) {
    return a.positions == b.positions && a.contacts == b.contacts;
  }
};

RunOutcome run(const SceneEntry<3>& entry, VolumeKind kind) {
  Bsp<3> tree({}, kind);
  const auto scene = entry.make(tree, {.objects = 120, .steps = 60, .recycle = 7});
  RunOutcome outcome;
  for (int step = 0; step < 150; ++step) {
    scene->advance();
    outcome.pairs += scene->pairs().size();
    outcome.met += scene->contacts().size();
  }
  for (const Body<3>& body : scene->bodies()) outcome.positions.push_back(body.pose.position);
  outcome.contacts.assign(scene->contacts().begin(), scene->contacts().end());
  return outcome;
}

// No contact is lost by a tighter volume, or the runs would part.
TEST(Volumes3D, EveryKindLeadsToTheSameRun) {
  for (const SceneEntry<3>& entry : scenes_3d()) {
    const RunOutcome box = run(entry, VolumeKind::box);
    ASSERT_GT(box.met, 1000U) << entry.name;
    ASSERT_FALSE(box.contacts.empty()) << entry.name;
    for (const VolumeKind kind : volume_kinds<3>()) {
      const RunOutcome other = run(entry, kind);
      EXPECT_EQ(other, box) << entry.name << " by " << to_string(kind);
      EXPECT_LE(other.pairs, box.pairs) << entry.name << " by " << to_string(kind);
    }
  }
}

}  // namespace
}  // namespace kerf::test
