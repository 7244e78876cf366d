#include "viz/draw/frame_renderer.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>

#include "tests/support/dimensions.h"
#include "tests/viz/small_scene.h"
#include "viz/draw/camera.h"
#include "viz/draw/overlay.h"
#include "viz/image/png.h"

namespace kerf {
namespace {

constexpr int kWidth = 480;
constexpr int kHeight = 270;

FrameOptions options(std::string_view layers = "all", int samples = 0) {
  FrameOptions result;
  result.width = kWidth;
  result.height = kHeight;
  result.layers = LayerSet::parse(layers);
  result.samples = samples;
  return result;
}

template <int D>
Image frame(const FrameInput<D>& input, const FrameOptions& how = options()) {
  return FrameRenderer<D>(how).render(input);
}

/// Hash of one frame of each kind: what must be the same in every process.
std::uint64_t hash_of_frames() {
  const test::SmallScene<2> flat;
  const test::SmallScene<3> solid;
  std::uint64_t hash = 0;
  for (const int samples : {1, 4}) {
    hash = 31 * hash + pixel_hash(frame(flat.input(), options("all", samples)));
    hash = 31 * hash + pixel_hash(frame(solid.input(), options("all", samples)));
  }
  return hash;
}

/// Runs `DISABLED_PrintHash` below in a process of its own.
std::string hash_in_new_process(const std::string& threads) {
  const std::string command =
      "LP_NUM_THREADS=" + threads + " '" + std::filesystem::read_symlink("/proc/self/exe").string() +
      "' --gtest_also_run_disabled_tests --gtest_filter=FrameProcess.DISABLED_PrintHash";
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(popen(command.c_str(), "r"), &pclose);
  std::string text;
  std::array<char, 256> line{};
  while (std::fgets(line.data(), static_cast<int>(line.size()), pipe.get()) != nullptr) text += line.data();
  const std::size_t at = text.find("hash=");
  return at == std::string::npos ? text : text.substr(at + 5, text.find('\n', at) - at - 5);
}

TEST(FrameProcess, DISABLED_PrintHash) {
  std::printf("hash=%llu\n", static_cast<unsigned long long>(hash_of_frames()));
}

TEST(FrameProcess, EveryProcessAndThreadCountDrawsTheSamePixels) {
  const std::string here = std::to_string(hash_of_frames());
  EXPECT_EQ(hash_in_new_process("0"), here);
  EXPECT_EQ(hash_in_new_process("2"), here);
}

template <class T>
class FrameRendererTest : public testing::Test {};
TYPED_TEST_SUITE(FrameRendererTest, test::Dimensions, test::DimensionNames);

TYPED_TEST(FrameRendererTest, SameInputSamePixels) {
  constexpr int kD = TypeParam::value;
  const test::SmallScene<kD> scene;
  FrameRenderer<kD> renderer(options());
  const std::uint64_t first = pixel_hash(renderer.render(scene.input()));
  EXPECT_EQ(pixel_hash(renderer.render(scene.input())), first);
  EXPECT_EQ(pixel_hash(frame(scene.input())), first);
}

TYPED_TEST(FrameRendererTest, EveryLayerChangesPixels) {
  constexpr int kD = TypeParam::value;
  const test::SmallScene<kD> scene;
  const Image all = frame(scene.input());
  for (int i = 0; i < kLayerCount; ++i) {
    const std::string name(to_string(static_cast<Layer>(i)));
    EXPECT_NE(frame(scene.input(), options("all,-" + name)), all) << name;
    FrameRenderer<kD> alone(options("none"));
    alone.set_view_box(Box<kD>{test::all<kD>(0), test::all<kD>(12)});
    const Image none = alone.render(scene.input());
    alone.set_layers(LayerSet::parse("none,+" + name));
    // The legend names the other layers, and tinted leaves are seen on objects only in 3D.
    const bool needs_others = name == "legend" || (kD == 3 && name == "leaves");
    const Image shown = alone.render(scene.input());
    EXPECT_TRUE(needs_others || shown != none) << name << " alone";
  }
}

TYPED_TEST(FrameRendererTest, PlaneMovedByAPixelIsSeen) {
  constexpr int kD = TypeParam::value;
  const test::SmallScene<kD> scene;
  const Box<kD> box{test::all<kD>(0), test::all<kD>(12)};
  const View view = frame_all(box, CameraChoice<kD>{}, {0, 0, kWidth, kHeight}, kWidth, kHeight);
  const double pixel = 1 / view.pixels_per_unit({6, 6, kD == 3 ? 6 : 0});
  Tree<kD> moved = scene.tree();
  moved[moved.root()].plane.offset += static_cast<Scalar>(pixel);
  FrameInput<kD> after = scene.input();
  after.tree = &moved;
  FrameRenderer<kD> renderer(options("partitioners"));
  renderer.set_view_box(box);
  const Image before = renderer.render(scene.input());
  EXPECT_NE(renderer.render(after), before);
}

TYPED_TEST(FrameRendererTest, EachPairAndEachContactIsSeen) {
  constexpr int kD = TypeParam::value;
  const test::SmallScene<kD> scene(60);
  const FrameInput<kD> input = scene.input();
  ASSERT_GE(input.contacts.size(), 2U);
  FrameRenderer<kD> renderer(options("pairs,contacts"));
  const Image whole = renderer.render(input);
  FrameInput<kD> without = input;
  without.contacts = without.contacts.first(input.contacts.size() - 1);  // now a candidate only
  EXPECT_NE(renderer.render(without), whole) << "a contact drawn as a candidate";
  without.contacts = {};
  without.pairs = {};
  const Image none = renderer.render(without);
  for (std::size_t i = 0; i < input.pairs.size(); ++i) {
    without.pairs = input.pairs.subspan(i, 1);
    EXPECT_NE(renderer.render(without), none) << "pair " << i;
  }
}

TYPED_TEST(FrameRendererTest, OperatorsAreNamedInTheScene) {
  constexpr int kD = TypeParam::value;
  const test::SmallScene<kD> scene(60);
  const NodeRef root = scene.tree().ref(scene.tree().root());
  const auto image_with = [&](Operator op) {
    const std::vector<Event> events{{1, 5, OperatorActed{op, root, {}, {}, 0, 3, 6}}};
    FrameInput<kD> input = scene.input();
    input.events = events;
    input.caption.step = 5;
    return frame(input, options("operators"));
  };
  // The same cell and the same plane: only the label differs.
  EXPECT_NE(image_with(Operator::split), image_with(Operator::shift_split));
}

/// However many have acted and however long their names, their text ends within the picture.
TYPED_TEST(FrameRendererTest, WhatActedIsShortenedToThePicture) {
  constexpr int kD = TypeParam::value;
  const test::SmallScene<kD> scene(60);
  std::vector<Event> events;
  for (std::uint32_t k = 0; k < 8; ++k)
    events.push_back({k, 5, OperatorActed{Operator::shift_split, {{1000 + k}, 0}, {}, {16, 9, 7}, 0, 3, 6}});
  FrameInput<kD> input = scene.input();
  input.events = events;
  input.caption.step = 5;
  for (const std::string note : {"", "e774 step 46 swap n3: 110 (34 | 77) -> 110"}) {
    input.caption.note = note;
    FrameOptions how;
    how.width = 640;
    how.height = 360;
    how.ids = true;
    FrameRenderer<kD> renderer(how);
    (void)renderer.render(input);
    const Font font(font_pixels(360));
    std::string log;
    for (const DrawnText& text : renderer.ids().list.texts) {
      EXPECT_LE(text.x + font.width(text.text), 640) << text.text;
      if (text.text.ends_with(" more")) log = text.text;
    }
    const std::string begin =
        note.empty() ? "leaf n1007 got crowded: split parallel to its parent's plane into 9 and 7"
                     : note + "   acted: shift-split n1007";
    EXPECT_TRUE(log.starts_with(begin)) << log;
    EXPECT_TRUE(log.ends_with(" more")) << log;
  }
}

TYPED_TEST(FrameRendererTest, BrokenInputIsDrawnWithoutHarm) {
  constexpr int kD = TypeParam::value;
  const test::SmallScene<kD> scene;
  std::vector<Body<kD>> bodies = scene.bodies();
  const Image before = frame(scene.input());
  bodies[3].pose.position[0] = std::numeric_limits<Scalar>::quiet_NaN();
  bodies[4].box.max[1] = std::numeric_limits<Scalar>::infinity();
  const std::vector<Pair> pairs{{ObjectId{0}, ObjectId{99999}}, {ObjectId{3}, ObjectId{4}}};
  FrameInput<kD> input = scene.input();
  input.bodies = bodies;
  input.pairs = pairs;
  input.contacts = pairs;
  EXPECT_NE(frame(input), before);
  EXPECT_NO_THROW(frame(FrameInput<kD>{}));
}

TYPED_TEST(FrameRendererTest, FramesAreOpaqueAndOfTheSizeAskedFor) {
  constexpr int kD = TypeParam::value;
  const test::SmallScene<kD> scene(40);
  for (const auto& [width, height] : {std::pair{64, 64}, {65, 97}, {333, 70}, {1000, 64}}) {
    FrameOptions how = options();
    how.width = width;
    how.height = height;
    const Image image = frame(scene.input(), how);
    EXPECT_EQ(image.width, width);
    EXPECT_EQ(image.height, height);
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) ASSERT_EQ(image.rgba[i], 255);
  }
}

TYPED_TEST(FrameRendererTest, RefusesBadOptions) {
  constexpr int kD = TypeParam::value;
  for (const int side : {-1, 0, kMinFrameSide - 1, kMaxFrameSide + 1, std::numeric_limits<int>::max()}) {
    FrameOptions how = options();
    how.width = side;
    EXPECT_THROW(FrameRenderer<kD>{how}, std::invalid_argument) << side;
    how = options();
    how.height = side;
    EXPECT_THROW(FrameRenderer<kD>{how}, std::invalid_argument) << side;
  }
  FrameOptions how = options();
  how.camera = "zoom=3";
  EXPECT_THROW(FrameRenderer<kD>{how}, std::invalid_argument);
  EXPECT_THROW(FrameRenderer<kD>{options("all", 3)}, std::invalid_argument);
}

/// The two backends, each drawing in turns: the same pixels, whatever the other did.
TYPED_TEST(FrameRendererTest, EglDrawsTheSamePixels) {
  constexpr int kD = TypeParam::value;
  const test::SmallScene<kD> scene;
  for (const int samples : {1, 4}) {
    FrameOptions how = options("all", samples);
    FrameRenderer<kD> osmesa(how);
    how.backend = GlBackend::egl;
    std::optional<FrameRenderer<kD>> egl;
    try {
      egl.emplace(how);
    } catch (const std::runtime_error& error) {
      GTEST_SKIP() << error.what();
    }
    const Image first = osmesa.render(scene.input());
    EXPECT_TRUE(egl->render(scene.input()) == first);
    EXPECT_TRUE(osmesa.render(scene.input()) == first);
    EXPECT_TRUE(egl->render(scene.input()) == first);
  }
}

TEST(FrameRenderer, RenderersOfBothDimensionsWorkSideBySide) {
  const test::SmallScene<2> flat;
  const test::SmallScene<3> solid;
  const std::uint64_t alone_2d = pixel_hash(frame(flat.input()));
  const std::uint64_t alone_3d = pixel_hash(frame(solid.input()));
  FrameRenderer<2> two(options());
  FrameRenderer<3> three(options());
  EXPECT_EQ(pixel_hash(two.render(flat.input())), alone_2d);
  EXPECT_EQ(pixel_hash(three.render(solid.input())), alone_3d);
  EXPECT_EQ(pixel_hash(two.render(flat.input())), alone_2d);
}

}  // namespace
}  // namespace kerf
