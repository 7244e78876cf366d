// Every structure that can be seen, one that cannot, and six side by side.

#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "frames/catalog/broad_phase_choice.h"
#include "frames/catalog/scene_catalog.h"
#include "frames/sequence/pane_of.h"
#include "frames/sequence/side_by_side.h"
#include "tests/images/reference_frames.h"
#include "tests/support/config_of.h"
#include "tests/support/dimensions.h"
#include "viz/draw/panes_renderer.h"
#include "viz/draw/view_box.h"

namespace kerf::test {
namespace {

/// A small scene after so many steps, with broad phases side by side.
template <int D>
PanesFrame<D> frame_of(const std::vector<std::string>& names) {
  constexpr std::uint32_t kSteps = 70;
  const auto* entry = std::get<const SceneEntry<D>*>(find_scene(D == 2 ? "buckets-2d" : "buckets").entry);
  SceneOptions options;
  options.objects = D == 2 ? 90 : 60;
  options.steps = kSteps - 10;
  std::vector<std::unique_ptr<BroadPhase<D>>> all;
  for (const std::string& name : names) {
    BroadPhaseChoice choice = choose_broad_phase(name, entry->needs);
    choice.volume = VolumeKind::box;
    if (choice.is_tree())
      choice.config = config_of(
          "min_threshold=8,max_threshold=16,schedule_interval=4,"
          "budget_divisor=2,max_redundancy=0.3,swap_share=1");
    all.push_back(make_broad_phase<D>(choice, *entry, options));
  }
  SideBySide<D> broad_phases(std::move(all));
  const auto scene = entry->make(broad_phases, options);
  while (scene->step() < kSteps) scene->advance();
  ViewBox<D> view;
  view.update(scene->bodies());
  PanesFrame<D> frame;
  frame.scene = D == 2 ? "buckets-2d" : "buckets";
  frame.step = scene->step();
  frame.objects = static_cast<std::uint32_t>(scene->bodies().size());
  frame.moving = options.objects;
  frame.bodies.assign(scene->bodies().begin(), scene->bodies().end());
  frame.contacts.assign(scene->contacts().begin(), scene->contacts().end());
  frame.bounds = view.box();
  for (std::size_t k = 0; k < names.size(); ++k) {
    frame.panes.push_back(pane_of<D>(names[k], broad_phases[k], frame.bodies, frame.bounds, std::nullopt));
    frame.has_strips |= !frame.panes.back().parts.lists.empty();
  }
  return frame;
}

FrameOptions options_of(int width, int height, bool ids) {
  FrameOptions options;
  options.width = width;
  options.height = height;
  options.ids = ids;
  if (const char* backend = std::getenv("KERF_BACKEND")) options.backend = parse_gl_backend(backend);
  return options;
}

template <class T>
class StructurePictures : public testing::Test {};
TYPED_TEST_SUITE(StructurePictures, Dimensions, DimensionNames);

TYPED_TEST(StructurePictures, OfEachStructure) {
  constexpr int kD = TypeParam::value;
  PanesRenderer<kD> renderer(options_of(560, 400, true));
  for (const std::string& name : broad_phase_names<kD>()) {
    // With the same parameters it has the same nodes; and one that is never built anew looks like one that
    // is.
    if (name == kTunedTree || name == "shifting-cuts-only") continue;
    const PanesFrame<kD> frame = frame_of<kD>({name});
    const StructureParts<kD>& parts = frame.panes.front().parts;
    const bool is_seen = !parts.cells.empty() || !parts.lists.empty();
    if (!is_seen && name != "cgal-box-intersection") continue;
    const Image& image = renderer.render(frame);
    EXPECT_EQ(compare_with_reference("structure-" + name + "-" + std::to_string(kD) + "d", image,
                                     {renderer.ids(), renderer.rasterizer()}),
              "");
  }
}

TYPED_TEST(StructurePictures, OfSixSideBySide) {
  constexpr int kD = TypeParam::value;
  std::vector<std::string> names{"kerf-paper", "bullet-dbvt",     "loose-octree",
                                 "columns",    "sweep-and-prune", "cgal-box-intersection"};
  PanesRenderer<kD> renderer(options_of(960, 640, false));
  const Image& image = renderer.render(frame_of<kD>(names));
  const FrameIds no_ids{
      {}, make_image(image.width, image.height, 0xff000000U)};  // of several panes there are none
  EXPECT_EQ(compare_with_reference("structures-" + std::to_string(kD) + "d", image,
                                   {no_ids, renderer.rasterizer()}),
            "");
}

/// What a pane shows does not depend on the pictures before it.
TYPED_TEST(StructurePictures, FollowFromTheirFrameAlone) {
  constexpr int kD = TypeParam::value;
  const PanesFrame<kD> frame = frame_of<kD>({"loose-octree", "sweep-and-prune"});
  PanesRenderer<kD> used(options_of(640, 360, false));
  static_cast<void>(used.render(frame_of<kD>({"columns", "bullet-dbvt"})));
  PanesRenderer<kD> fresh(options_of(640, 360, false));
  EXPECT_EQ(used.render(frame), fresh.render(frame));
}

}  // namespace
}  // namespace kerf::test
