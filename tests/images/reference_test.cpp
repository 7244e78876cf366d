#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "tests/images/operator_moments.h"
#include "tests/images/reference_frames.h"
#include "tests/images/scene_still.h"
#include "tests/support/dimensions.h"

namespace kerf {
namespace {

FrameOptions options() {
  FrameOptions options;
  options.width = 480;
  options.height = 270;
  options.ids = true;
  if (const char* backend = std::getenv("KERF_BACKEND")) options.backend = parse_gl_backend(backend);
  return options;
}

template <class T>
class ReferenceFrames : public testing::Test {};
TYPED_TEST_SUITE(ReferenceFrames, test::Dimensions, test::DimensionNames);

TYPED_TEST(ReferenceFrames, EveryScene) {
  constexpr int kD = TypeParam::value;
  for (const CatalogScene& scene : scene_catalog()) {
    if (scene.dimension() != kD) continue;
    const test::SceneStill<kD> still(scene.name);
    FrameOptions how = options();
    how.layers.set(Layer::operators, false);  // they have pictures of their own
    FrameRenderer<kD> renderer(how);
    const Image& image = renderer.render(still.input());
    EXPECT_EQ(test::compare_with_reference("scene-" + scene.name, renderer, image), "");
  }
}

TYPED_TEST(ReferenceFrames, EveryLayerAlone) {
  constexpr int kD = TypeParam::value;
  const test::SceneStill<kD> still(kD == 2 ? "buckets-2d" : "buckets");
  for (int i = 0; i < kLayerCount; ++i) {
    const auto layer = static_cast<Layer>(i);
    FrameOptions how = options();
    how.layers = LayerSet::none().with(layer, true);
    if (layer == Layer::leaves && kD == 3) how.layers.set(Layer::objects, true);  // which it tints
    FrameRenderer<kD> renderer(how);
    const Image& image = renderer.render(still.input());
    const std::string name = "layer-" + std::string(to_string(layer)) + "-" + std::to_string(kD) + "d";
    EXPECT_EQ(test::compare_with_reference(name, renderer, image), "");
  }
}

TYPED_TEST(ReferenceFrames, EachOperatorBeforeAndAfter) {
  constexpr int kD = TypeParam::value;
  const test::OperatorMoments<kD> moments;
  for (int i = 0; i < kOperatorCount; ++i) {
    const auto op = static_cast<Operator>(i);
    const test::OperatorMoment<kD>* moment = moments.of(op);
    ASSERT_NE(moment, nullptr) << to_string(op) << " never acted";
    FrameRenderer<kD> renderer(options());
    FrameInput<kD> input{moment->bodies_before, &moment->before, moment->pairs_before, {}, {}, {}};
    input.caption.scene = "swarm";
    input.caption.broad_phase = "kerf-paper";
    input.caption.step = moment->event.step - 1;
    input.caption.objects = input.caption.moving = static_cast<std::uint32_t>(moment->bodies_after.size());
    input.caption.pairs = moment->pairs_before.size();
    input.caption.statistics = moment->statistics;
    const std::string name = std::string(to_string(op)) + "-" + std::to_string(kD) + "d";
    EXPECT_EQ(test::compare_with_reference("operator-" + name + "-before", renderer, renderer.render(input)),
              "");
    const std::vector<Event> events{moment->event};
    input.bodies = moment->bodies_after;
    input.tree = &moment->after;
    input.pairs = moment->pairs_after;
    input.events = events;
    input.caption.step = moment->event.step;
    input.caption.pairs = moment->pairs_after.size();
    EXPECT_EQ(test::compare_with_reference("operator-" + name + "-after", renderer, renderer.render(input)),
              "");
  }
}

}  // namespace
}  // namespace kerf
