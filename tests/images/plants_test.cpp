#include "tests/images/plants.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <string>

#include "frames/diff/frame_diff.h"
#include "frames/sequence/draw_list_file.h"
#include "tests/images/scene_still.h"
#include "tests/support/dimensions.h"
#include "tests/support/temporary_folder.h"
#include "viz/draw/compare_drawn.h"
#include "viz/image/compare.h"
#include "viz/image/flip.h"
#include "viz/image/png.h"

namespace kerf::test {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

constexpr int kWidth = 480;
constexpr int kHeight = 270;

/// A scene, drawn as it is and with bugs.
template <class T>
class PlantedBugs : public ::testing::Test {
 protected:
  static constexpr int kD = T::value;

  PlantedBugs() : still_(kD == 2 ? "buckets-2d" : "buckets") {
    std::filesystem::create_directories(folder_.path());
    draw("right", {});
    right_ = read_ids(path("right"))->ids;
  }

  [[nodiscard]] std::filesystem::path path(const std::string& name) const {
    return folder_.path() / (name + ".png");
  }

  void draw(const std::string& name, const Tamper& tamper) {
    FrameOptions options;
    options.width = kWidth;
    options.height = kHeight;
    options.ids = true;
    FrameRenderer<kD> renderer(options);
    renderer.set_tamper(tamper);
    write_png(path(name), renderer.render(still_.input()));
    write_ids(path(name), {renderer.ids(), renderer.rasterizer()});
  }

  FrameDiff diff(DiffGate gate, const std::string& name = "planted") {
    return diff_frame({name, path("right"), path(name)}, {gate});
  }

  /// What finds the bug by itself: 'p'ixels, 'd'raw list, 'i'd image, 'F'LIP's maximum.
  std::string found_by(Plant plant) {
    draw("planted", test::tamper(plant, test::victim(plant, right_), kWidth, kHeight));
    const FrameIds planted = read_ids(path("planted"))->ids;
    const Image right = read_png(path("right"));
    const Image wrong = read_png(path("planted"));
    std::string found;
    if (!compare_pixels(right, wrong).same()) found += 'p';
    if (!compare_drawn(right_, {planted.list, right_.image}).empty()) found += 'd';
    if (!compare_drawn(right_, {right_.list, planted.image}).empty()) found += 'i';
    if (summarize_flip(flip_errors(right, wrong)).max > kFlipLimit) found += 'F';
    return found;
  }

  /// Plants the bug and expects each gate to object, the message to name what is wrong.
  void expect_found(Plant plant, const std::string& verb) {
    const Drawn victim = test::victim(plant, right_);
    draw("planted", test::tamper(plant, victim, kWidth, kHeight));
    const std::string message = name_of(victim) + " " + verb;
    for (const DiffGate gate : {DiffGate::automatic, DiffGate::exact, DiffGate::ids, DiffGate::flip}) {
      const FrameDiff found = diff(gate);
      EXPECT_EQ(found.trouble, "");
      EXPECT_FALSE(found.same) << to_string(gate);
      EXPECT_THAT(found.reasons, Contains(HasSubstr(message))) << to_string(gate);
    }
  }

 private:
  test::TemporaryFolder folder_;
  test::SceneStill<kD> still_;
  FrameIds right_;
};
TYPED_TEST_SUITE(PlantedBugs, test::Dimensions, test::DimensionNames);

TYPED_TEST(PlantedBugs, MissingPlane) { this->expect_found(Plant::missing_plane, "missing"); }
TYPED_TEST(PlantedBugs, PlaneMovedByOnePixel) { this->expect_found(Plant::moved_plane, "moved by"); }
TYPED_TEST(PlantedBugs, MissingPairLine) { this->expect_found(Plant::missing_pair, "missing"); }
TYPED_TEST(PlantedBugs, RecolouredPair) { this->expect_found(Plant::recolored_pair, "recoloured from"); }
TYPED_TEST(PlantedBugs, LeafTintedByFourPercent) { this->expect_found(Plant::leaf_tint, "tinted from"); }
TYPED_TEST(PlantedBugs, MissingBox) { this->expect_found(Plant::missing_box, "missing"); }

// Each part of the gates is proved without the others. Pixels and the draw list find everything; the id image
// has no colours and forgives a pixel, FLIP's maximum does not mind what is thin or faint
// (docs/IMAGE_DIFF.md).
TYPED_TEST(PlantedBugs, EachPartOfTheGatesFindsThemAlone) {
  const std::string missing = TestFixture::kD == 2 ? "pdiF" : "pdi";
  EXPECT_THAT(this->found_by(Plant::missing_plane), StartsWith(missing));
  EXPECT_THAT(this->found_by(Plant::missing_box), StartsWith(missing));
  EXPECT_THAT(this->found_by(Plant::moved_plane), StartsWith("pd"));
  EXPECT_THAT(this->found_by(Plant::missing_pair), StartsWith("pd"));
  EXPECT_THAT(this->found_by(Plant::recolored_pair), StartsWith("pd"));
  EXPECT_THAT(this->found_by(Plant::leaf_tint), StartsWith("pd"));
}

TYPED_TEST(PlantedBugs, DrawnAgainNothingIsFound) {
  this->draw("again", {});
  for (const DiffGate gate : {DiffGate::automatic, DiffGate::exact, DiffGate::ids, DiffGate::flip}) {
    const FrameDiff found = this->diff(gate, "again");
    EXPECT_TRUE(found.same) << to_string(gate);
    EXPECT_THAT(found.reasons, IsEmpty());
    EXPECT_THAT(found.drawn, IsEmpty());
  }
}

}  // namespace
}  // namespace kerf::test
