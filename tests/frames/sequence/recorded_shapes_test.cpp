#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>

#include "core/recording/shape_rows.h"
#include "core/replay/recorded_looks.h"
#include "core/replay/replayer.h"
#include "core/scene/shape_kind.h"
#include "frames/catalog/scene_catalog.h"
#include "tests/frames/program.h"
#include "viz/draw/frame_planner.h"
#include "viz/draw/recorded_bodies.h"
#include "viz/draw/view_box.h"
#include "viz/image/compare.h"

namespace kerf {
namespace {

using ::testing::HasSubstr;

/// A scene, recorded by the program, and the same scene live, after its last step.
template <int D>
class TwoWays {
 public:
  static constexpr std::uint32_t kObjects = 60;
  static constexpr std::uint32_t kSteps = 40;
  static constexpr std::uint32_t kGrow = 20;

  explicit TwoWays(const std::string& name) {
    const auto* entry = std::get<const SceneEntry<D>*>(find_scene(name).entry);
    std::vector<std::string> arguments{
        "record", name,      "-o", file(),     "--objects",
        "60",     "--steps", "40", "--config", "max_threshold=24,min_threshold=12"};
    if (entry->grows) arguments.insert(arguments.end(), {"--grow", "20"});
    const test::RunOutcome recorded = test::run_kerf(arguments);
    EXPECT_EQ(recorded.exit, 0) << recorded.err;
    SceneOptions options;
    options.objects = kObjects;
    if (entry->grows) options.steps = kGrow;
    scene_ = entry->make(tree_, options);
    while (scene_->step() < kSteps) scene_->advance();
    recording_ = std::make_shared<RecordingReader<D>>(file());
    Replayer<D> replayer(recording_);
    replayer.seek(kSteps);
    RecordedLooks<D> looks(*recording_);
    recorded_ = recorded_bodies<D>(replayer.tree().objects(),
                                   {looks.at(kSteps), recording_->shapes(), recording_->info().marks});
  }

  [[nodiscard]] std::string file() const { return folder_.path() / "a.kerf"; }
  [[nodiscard]] std::span<const Body<D>> live() const { return scene_->bodies(); }
  [[nodiscard]] std::span<const Body<D>> recorded() const { return recorded_; }

  /// Only objects: everything else comes from the tree, and is drawn of the same one.
  [[nodiscard]] Image picture(std::span<const Body<D>> bodies) const {
    FrameOptions options;
    options.width = 640;
    options.height = 360;
    options.layers = LayerSet::none().with(Layer::objects, true);
    const FrameInput<D> input{
        .bodies = bodies, .tree = &tree_.tree(), .pairs = {}, .contacts = {}, .events = {}, .caption = {}};
    ViewBox<D> view;
    view.update(live());
    FramePlanner<D> planner(options.layers, 4);
    planner.fix_view_box(view.box());
    FrameRenderer<D> renderer(options);
    return renderer.render(input, planner.plan(input));
  }

 private:
  test::TemporaryFolder folder_;
  Bsp<D> tree_;
  std::unique_ptr<Scene<D>> scene_;
  std::shared_ptr<RecordingReader<D>> recording_;
  std::vector<Body<D>> recorded_;
};

template <int D>
void expect_alike(const Body<D>& live, const Body<D>& recorded) {
  EXPECT_EQ(encode_shape<D>(recorded.shape), encode_shape<D>(live.shape));
  EXPECT_EQ(recorded.box, live.box);
  EXPECT_EQ(recorded.mobility, live.mobility);
  EXPECT_LE(length(recorded.pose.position - live.pose.position), 1e-4F);
  if (D == 3 && is_ball<D>(live.shape)) return;  // however it is turned
  for (std::size_t axis = 0; axis < D; ++axis)
    EXPECT_LE(length(recorded.pose.axes[axis] - live.pose.axes[axis]), 0x1p-11F);
}

template <int D>
void expect_alike(const std::string& name) {
  const TwoWays<D> scene(name);
  ASSERT_EQ(scene.recorded().size(), scene.live().size());
  for (std::size_t k = 0; k < scene.live().size(); ++k) {
    SCOPED_TRACE(name + ", object " + std::to_string(k));
    expect_alike<D>(scene.live()[k], scene.recorded()[k]);
  }
  const auto differences = compare_pixels(scene.picture(scene.live()), scene.picture(scene.recorded()));
  // The faces of spheres, which are drawn turned, are not recorded as such; what is turned is rounded.
  EXPECT_LT(differences.different, 640U * 360U / (D == 2 ? 1000 : 30)) << name;
}

/// Discs and boxes; what breaks; outlines on which they roll.
TEST(RecordedShapes, OfScenesIn2DAreThoseOfTheLiveScene) {
  for (const char* const name : {"pile", "fracture-2d", "terrain-2d"}) expect_alike<2>(name);
}

/// Balls and boxes; what breaks; surfaces on which they roll.
TEST(RecordedShapes, OfScenesIn3DAreThoseOfTheLiveScene) {
  for (const char* const name : {"buckets", "fracture", "terrain"}) expect_alike<3>(name);
}

/// A disc leaves the corners of its box free, and a box that lies aslant does, too.
TEST(RecordedShapes, ArePicturedAsThemselvesAndNotAsTheirBoxes) {
  const TwoWays<2> scene("pile");
  std::vector<Body<2>> boxes(scene.recorded().begin(), scene.recorded().end());
  for (Body<2>& body : boxes) {
    body.shape = Brick<2>{body.box.extent() * 0.5F};
    body.pose = {body.box.center(), identity_axes<2>()};
  }
  const Image live = scene.picture(scene.live());
  EXPECT_GT(compare_pixels(live, scene.picture(boxes)).different,
            20 * compare_pixels(live, scene.picture(scene.recorded())).different);
}

TEST(RecordedShapes, AreNamedByVerify) {
  const TwoWays<3> scene("terrain");
  const test::RunOutcome verified = test::run_kerf({"verify", scene.file()});
  EXPECT_EQ(verified.exit, 0) << verified.err;
  EXPECT_THAT(verified.out, ::testing::ContainsRegex("shapes: [0-9]+ balls, [0-9]+ bricks, [0-9]+ surfaces"));
}

}  // namespace
}  // namespace kerf
