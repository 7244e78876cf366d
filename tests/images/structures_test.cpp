// Every kind of structure that can be seen, one that cannot, and six side by side.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "frames/catalog/broad_phase_choice.h"
#include "frames/catalog/scene_catalog.h"
#include "frames/sequence/farm/panes_parcel.h"
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

/// One structure of each kind: those of one kind have the same drawing of other descriptions, which
/// tests/frames/catalog/structure_test.cpp holds against the boxes. Of planes and of cuts those are drawn
/// that have the most directions.
TYPED_TEST(StructurePictures, OfEachKind) {
  constexpr int kD = TypeParam::value;
  std::set<std::string> names{"kerf-paper",       "evolved-planes",    "reinserting-tree",
                              "loose-octree",     "columns",           "sort-and-sweep",
                              "sweep-and-prune",  "sphere-tree",       "bullet-dbvt",
                              "multi-level-hash", "bullet-axis-sweep", "cgal-box-intersection"};
  names.insert(kD == 2 ? "box2d-tree" : "fcl-dynamic-tree");
  PanesRenderer<kD> renderer(options_of(560, 400, true));
  std::set<std::string> kinds;
  std::set<std::string> drawn;
  for (const std::string& name : broad_phase_names<kD>()) {
    const PanesFrame<kD> frame = frame_of<kD>({name});
    const StructureParts<kD>& parts = frame.panes.front().parts;
    if (!parts.cells.empty() || !parts.lists.empty()) kinds.insert(parts.kind);
    if (!names.contains(name)) continue;
    drawn.insert(parts.kind);
    const Image& image = renderer.render(frame);
    EXPECT_EQ(compare_with_reference("structure-" + name + "-" + std::to_string(kD) + "d", image,
                                     {renderer.ids(), renderer.rasterizer()}),
              "");
  }
  EXPECT_TRUE(std::ranges::includes(drawn, kinds)) << "a kind of structure has no picture";
}

TYPED_TEST(StructurePictures, OfSixSideBySide) {
  constexpr int kD = TypeParam::value;
  std::vector<std::string> names{"kerf-paper", "bullet-dbvt",     "loose-octree",
                                 "columns",    "sweep-and-prune", "cgal-box-intersection"};
  PanesRenderer<kD> renderer(options_of(960, 640, false));
  const Image& image = renderer.render(frame_of<kD>(names));
  const FrameIds no_ids{
      {}, make_image(image.width, image.height, 0x000000ffU)};  // of several panes there are none
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

/// Pictures of a sequence are drawn in other processes.
TYPED_TEST(StructurePictures, AreTheSameFromAParcel) {
  constexpr int kD = TypeParam::value;
  const PanesFrame<kD> frame = frame_of<kD>({"sphere-tree", "sweep-and-prune"});
  PanesRenderer<kD> here(options_of(640, 360, false));
  PanesRenderer<kD> there(options_of(640, 360, false));
  EXPECT_EQ(here.render(frame), there.render(unpack_panes<kD>(pack_panes(frame))));
}

}  // namespace
}  // namespace kerf::test
