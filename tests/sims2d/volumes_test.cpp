#include <box2d/b2_math.h>
#include <gtest/gtest.h>

#include "core/bsp/bsp.h"
#include "core/geometry/volume.h"
#include "sims2d/convert.h"
#include "sims2d/scenes/scenes.h"

namespace kerf::test {
namespace {

Volume<2> volume_of(VolumeKind kind, const Body<2>& body) {
  const std::unique_ptr<b2Shape> shape = to_box2d(body.shape);
  b2Transform transform;
  transform.p.Set(body.pose.position[0], body.pose.position[1]);
  transform.q.c = body.pose.axes[0][0];
  transform.q.s = body.pose.axes[0][1];
  return padded_volume(kind, body.shape, *shape, transform);
}

// Box2D's solver depends on which pairs are candidates, so runs may part; but what touches must be a pair of
// every kind.
TEST(Volumes2D, EveryContactIsAPairOfEveryKind) {
  for (const SceneEntry<2>& entry : scenes_2d()) {
    Bsp<2> tree;
    const auto scene = entry.make(tree, {.objects = 150, .steps = 80, .recycle = 7});
    std::size_t contacts = 0;
    for (int step = 0; step < 200; ++step) {
      scene->advance();
      for (const Pair& pair : scene->contacts()) {
        ++contacts;
        for (const VolumeKind kind : volume_kinds<2>()) {
          const Volume<2> a = volume_of(kind, scene->bodies()[pair.a.index()]);
          const Volume<2> b = volume_of(kind, scene->bodies()[pair.b.index()]);
          ASSERT_TRUE(overlaps(a.box, b.box) && volumes_overlap<2>(kind, a.extra.data(), b.extra.data()))
              << entry.name << " step " << step << ": " << pair.a.value << "-" << pair.b.value << " by "
              << to_string(kind);
        }
      }
    }
    EXPECT_GT(contacts, 5000U) << entry.name;
  }
}

}  // namespace
}  // namespace kerf::test
