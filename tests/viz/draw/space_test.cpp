#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/viz/small_scene.h"
#include "viz/draw/triad.h"

/// What pictures in 3D have beside the objects: walls in tiles, shadows, outlines, haze, axes.
namespace kerf {
namespace {

Body<3> body_of(Shape<3> shape, const Vector<3>& center, const Vector<3>& half,
                Mobility mobility = Mobility::moving) {
  Body<3> body;
  body.shape = std::move(shape);
  body.pose.position = center;
  body.box = {center - half, center + half};
  body.mobility = mobility;
  return body;
}
Body<3> brick(const Vector<3>& center, const Vector<3>& half, Mobility mobility = Mobility::moving) {
  return body_of(Brick<3>{half}, center, half, mobility);
}
const Body<3> kFloor = brick({{0, -1, 0}}, {{10, 1, 10}}, Mobility::fixed);

const Box<3> kRoom{{{-10, -2, -10}}, {{10, 8, 10}}};

FrameOptions options(const char* layers, const char* camera = "top") {
  FrameOptions result;
  result.width = 320;
  result.height = 320;
  result.samples = 1;
  result.layers = LayerSet::parse(layers);
  result.camera = camera;
  return result;
}

Image picture(const std::vector<Body<3>>& bodies, const char* camera = "top") {
  FrameRenderer<3> renderer(options("objects", camera));
  renderer.set_view_box(kRoom);
  return renderer.render({bodies, nullptr, {}, {}, {}, {}});
}

int brightness(const Image& image, int x, int y) {
  const std::uint8_t* const pixel = image.pixel(x, y);
  return pixel[0] + pixel[1] + pixel[2];
}

View view_from(const char* camera) {
  return frame_all(kRoom, parse_camera<3>(camera), {0, 0, 320, 320}, 320, 320);
}

int brightness_at(const Image& image, const char* camera, const Eigen::Vector3d& point) {
  const Eigen::Vector2d at = *view_from(camera).project(point);
  return brightness(image, static_cast<int>(at.x()), static_cast<int>(at.y()));
}

/// How much darker a point of the ground gets by what stands there, `times` over.
int shade_at(const Eigen::Vector3d& point, const Body<3>& body, std::size_t times = 1) {
  std::vector<Body<3>> bodies{kFloor};
  const int bare = brightness_at(picture(bodies, "iso"), "iso", point);
  bodies.insert(bodies.end(), times, body);
  return bare - brightness_at(picture(bodies, "iso"), "iso", point);
}

TEST(Shadows, LieOnTheGroundAroundWhatStandsThere) {
  const Body<3> block = brick({{0, 1, 0}}, {{1, 1, 1}});
  EXPECT_GT(shade_at({1.1, 0, 1.1}, block), 20);
  EXPECT_EQ(shade_at({3, 0, 3}, block), 0);
}

TEST(Shadows, FadeWithTheHeightAndEnd) {
  const auto shade = [](Scalar height) {
    return shade_at({-4, 0, -4}, brick({{-4, height, -4}}, {{0.5F, 0.5F, 0.5F}}));
  };
  EXPECT_GT(shade(2.5F), 20);
  EXPECT_LT(shade(5), shade(2.5F));
  EXPECT_EQ(shade(9.5F), 0);
}

/// Else the ground below a heap would be black.
TEST(Shadows, OnShadowsAreNoDarker) {
  const Body<3> block = brick({{0, 1, 0}}, {{1, 1, 1}});
  EXPECT_EQ(shade_at({1.1, 0, 1.1}, block, 6), shade_at({1.1, 0, 1.1}, block));
}

TEST(Shadows, TheDarkerOneRemains) {
  const Body<3> low = brick({{0, 1, 0}}, {{1, 1, 1}});
  const Body<3> high = brick({{0, 6, 0}}, {{1, 1, 1}});
  for (const auto& bodies : {std::vector{kFloor, low, high}, std::vector{kFloor, high, low}})
    EXPECT_EQ(brightness_at(picture(bodies, "iso"), "iso", {1.1, 0, 1.1}),
              brightness_at(picture({kFloor, low}, "iso"), "iso", {1.1, 0, 1.1}));
}

TEST(Outlines, AreDarkAndOnlyOfWhatIsLargeEnough) {
  const auto darkest = [](Scalar half, const Shape<3>& shape) {
    const Image image = picture({body_of(shape, {{0, 4, 0}}, {{half, half, half}})}, "front");
    int least = 765;
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) least = std::min(least, brightness(image, x, y));
    return least;
  };
  EXPECT_LT(darkest(3, Brick<3>{{{3, 3, 3}}}), darkest(0.1F, Brick<3>{{{0.1F, 0.1F, 0.1F}}}) - 60);
  EXPECT_LT(darkest(3, Ball{3}), darkest(0.1F, Ball{0.1F}) - 40);
}

TEST(Haze, WhatIsFarAwayIsNearerToTheGround) {
  const auto light_at = [](Scalar z) {
    return brightness_at(picture({brick({{0, 3, z}}, {{2, 2, 1}})}, "front"), "front", {0, 3, z});
  };
  EXPECT_GT(light_at(-8), light_at(8) + 15);
}

TEST(Stage, EachLeafAtAFarWallHasATileOfItsOwn) {
  const test::SmallScene<3> scene;
  FrameOptions how = options("leaves", "iso");
  how.ids = true;
  FrameRenderer<3> renderer(how);
  static_cast<void>(renderer.render(scene.input()));
  std::set<std::uint32_t> leaves;
  std::size_t seen = 0;
  for (const Drawn& drawn : renderer.ids().list.items) {
    if (drawn.kind != DrawnKind::leaf) continue;
    EXPECT_TRUE(leaves.insert(drawn.a).second) << "n" << drawn.a << " is drawn as one thing";
    EXPECT_TRUE(scene.tree()[NodeId{drawn.a}].is_leaf());
    seen += drawn.pixels > 0 ? 1 : 0;
  }
  EXPECT_GT(seen, 3U);
}

/// An object that lies outside of the bounds is seen all the same.
TEST(Stage, LiesBehindEverything) {
  const test::SmallScene<3> scene;
  const auto pixels_of_objects = [&](const char* layers) {
    FrameOptions how = options(layers, "front");
    how.ids = true;
    FrameRenderer<3> renderer(how);
    renderer.set_view_box({{{3, 3, 6}}, {{6, 6, 9}}});
    static_cast<void>(renderer.render(scene.input()));
    std::uint32_t pixels = 0;
    for (const Drawn& drawn : renderer.ids().list.items)
      if (drawn.kind == DrawnKind::object) pixels += drawn.pixels;
    return pixels;
  };
  EXPECT_EQ(pixels_of_objects("objects,leaves"), pixels_of_objects("objects"));
}

TEST(Triad, NamesTheAxesWhereTheyPoint) {
  const auto letters = [](const char* camera) {
    const View view =
        frame_all(Box<3>{{{0, 0, 0}}, {{1, 1, 1}}}, parse_camera<3>(camera), {0, 0, 400, 400}, 400, 400);
    const Font font(14);
    Overlay overlay;
    overlay.text.keeps_lines = true;
    draw_triad(view, font, {0, 0, 400, 400}, Corner::left, 40, overlay);
    return overlay.text.lines;
  };
  const auto find = [](const std::vector<DrawnText>& lines, const char* name) {
    return *std::ranges::find(lines, name, &DrawnText::text);
  };
  const auto front = letters("front");
  ASSERT_EQ(front.size(), 2U) << "z points at the viewer";
  EXPECT_GT(find(front, "x").x, find(front, "y").x);
  EXPECT_LT(find(front, "y").y, find(front, "x").y);
  const auto top = letters("top");
  ASSERT_EQ(top.size(), 2U);
  EXPECT_GT(find(top, "z").y, find(top, "x").y) << "z points down";
  EXPECT_EQ(letters("iso").size(), 3U);
}

/// Triangles of a body, drawn while the camera turns or not.
std::size_t triangles_of(const Body<3>& body, bool brief) {
  const std::vector<Body<3>> bodies{body};
  const FrameInput<3> input{bodies, nullptr, {}, {}, {}, {}};
  const View view = view_from("iso");
  const TreeSnapshotOf<3> snapshot;
  const std::vector<Placement> placements;
  DrawContext<3> context{input, view, snapshot, placements, kRoom, LayerSet::parse("objects")};
  context.brief = brief;
  Batch solid;
  Batch glass;
  draw_objects(context, solid, glass);
  return (solid.indices.size() + glass.indices.size()) / 3;
}

TEST(WhileTheCameraTurns, ASmallBlockIsASquareAndOthersAreAsTheyAre) {
  const Body<3> small = brick({{0, 1, 0}}, {{0.2F, 0.2F, 0.2F}});
  EXPECT_EQ(triangles_of(small, true), 2U);
  EXPECT_EQ(triangles_of(small, false), 6U);
  EXPECT_EQ(triangles_of(brick({{0, 1, 0}}, {{2, 2, 2}}), true), 6U);
  EXPECT_EQ(triangles_of(brick({{0, 1, 0}}, {{0.1F, 0.1F, 0.3F}}), true), 6U) << "a rod is no square";
  EXPECT_EQ(triangles_of(body_of(Ball{0.2F}, {{0, 1, 0}}, {{0.2F, 0.2F, 0.2F}}), true), 2U);
}

/// The floor has the colours of the leaves behind it, which are darker than the ground of the picture.
TEST(Shadows, AreNowhereLighterThanAFloorInTheColoursOfItsLeaves) {
  const test::SmallScene<3> scene;
  std::vector<Body<3>> bodies = scene.bodies();
  for (Body<3>& body : bodies) {
    body.mobility = Mobility::moving;
    body.shape = Brick<3>{body.box.extent() * 0.5F};
  }
  FrameInput<3> input = scene.input();
  input.bodies = bodies;
  FrameOptions how = options("leaves,objects", "iso");
  how.ids = true;
  FrameRenderer<3> renderer(how);
  renderer.set_view_box(Box<3>{test::all<3>(0), test::all<3>(12)});
  const Image shown = renderer.render(input);
  const FrameIds ids = renderer.ids();
  renderer.set_layers(LayerSet::parse("leaves"));
  const Image floor = renderer.render(input);
  int darker = 0;
  int lighter = 0;
  for (int y = 0; y < shown.height; ++y)
    for (int x = 0; x < shown.width; ++x) {
      const std::uint32_t item = item_of(ids.image.pixel(x, y));
      if (item != 0 && ids.list.items[item - 1].kind == DrawnKind::object) continue;
      darker += brightness(shown, x, y) < brightness(floor, x, y) ? 1 : 0;
      lighter += brightness(shown, x, y) > brightness(floor, x, y) ? 1 : 0;
    }
  EXPECT_GT(darker, 100);
  EXPECT_EQ(lighter, 0);
}

}  // namespace
}  // namespace kerf
