// Bodies smaller than a pixel are seen, and stay where they are.

#include "viz/draw/least_shape.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"
#include "viz/draw/camera.h"
#include "viz/draw/clip.h"

namespace kerf::test {
namespace {

constexpr int kWidth = 480;
constexpr int kHeight = 270;

template <int D>
Body<D> body_of(const Vector<D>& place, const Shape<D>& shape, const Vector<D>& half) {
  Body<D> body;
  body.pose.position = place;
  body.shape = shape;
  body.box = {place - half, place + half};
  return body;
}

template <int D>
Body<D> brick_at(const Vector<D>& place, Scalar length = 0) {
  Vector<D> half;
  half[0] = length / 2;
  return body_of<D>(place, Brick<D>{half}, half);
}

/// A point of each kind that a dimension has.
template <int D>
Body<D> speck_at(const Vector<D>& place, std::uint32_t kind) {
  if (kind == 0) return body_of<D>(place, Ball{0}, {});
  if constexpr (D == 2)
    if (kind == 1) return body_of<D>(place, Outline{{{{0, 0}}, {{0, 0}}, {{0, 0}}}}, {});
  return brick_at(place);
}

/// Pictures of single bodies in the cube from 0 to 12, or in one as large that begins elsewhere.
template <int D>
class Alone {
 public:
  explicit Alone(Scalar begin = 0) : box_{all<D>(begin), all<D>(begin + 12)} {
    FrameOptions options;
    options.width = kWidth;
    options.height = kHeight;
    options.layers = LayerSet::parse("objects");
    options.samples = 1;
    renderer_.emplace(options);
    renderer_->set_view_box(box_);
    none_ = renderer_->render(FrameInput<D>{});
  }
  /// How many pixels a body changes.
  int pixels_of(const Body<D>& body) {
    FrameInput<D> input;
    input.bodies = {&body, 1};
    const Image& shown = renderer_->render(input);
    int count = 0;
    darkest_ = 255;
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        const std::uint8_t* const pixel = shown.pixel(x, y);
        if (std::equal(pixel, pixel + 3, none_.pixel(x, y))) continue;
        ++count;
        darkest_ = std::min(darkest_, int{*std::max_element(pixel, pixel + 3)});
      }
    return count;
  }
  /// The largest channel of the darkest pixel of that body.
  [[nodiscard]] int darkest() const { return darkest_; }
  [[nodiscard]] Scalar pixel_at(const Vector<D>& place) const {
    const View view = frame_all(box_, CameraChoice<D>{}, {0, 0, kWidth, kHeight}, kWidth, kHeight);
    return static_cast<Scalar>(1 / view.pixels_per_unit(to_point(place)));
  }

 private:
  Box<D> box_;
  std::optional<FrameRenderer<D>> renderer_;
  Image none_;
  int darkest_ = 255;
};

template <class T>
class LeastShape : public testing::Test {};
TYPED_TEST_SUITE(LeastShape, Dimensions, DimensionNames);

TYPED_TEST(LeastShape, OfAPointIsSeenWhereverItLies) {
  constexpr int kD = TypeParam::value;
  Alone<kD> pictures;
  Random random(8);
  for (std::uint32_t k = 0; k < 150; ++k)
    EXPECT_GE(pictures.pixels_of(speck_at<kD>(random_point<kD>(random, 3, 9), k % 3)), 1) << "point " << k;
}

/// Two pixels in the colour of its leaf were not found.
TYPED_TEST(LeastShape, OfAPointIsADotWithADarkRim) {
  constexpr int kD = TypeParam::value;
  Alone<kD> pictures;
  for (std::uint32_t kind = 0; kind < 3; ++kind) {
    EXPECT_GE(pictures.pixels_of(speck_at<kD>(all<kD>(6), kind)), 20) << "kind " << kind;
    EXPECT_LT(pictures.darkest(), 160) << "kind " << kind;
  }
  const Vector<kD> half = all<kD>(pictures.pixel_at(all<kD>(6)) * 0.25F);
  EXPECT_LE(pictures.pixels_of(body_of<kD>(all<kD>(6), Brick<kD>{half}, half)), 12)
      << "what has a size looks as before";
}

TYPED_TEST(LeastShape, OfAShortRodIsInOnePiece) {
  constexpr int kD = TypeParam::value;
  Alone<kD> pictures;
  Random random(8);
  for (int k = 0; k < 20; ++k) {
    const Vector<kD> place = random_point<kD>(random, 3, 9);
    EXPECT_GE(pictures.pixels_of(brick_at(place, 30 * pictures.pixel_at(place))), 15) << "rod " << k;
  }
}

/// Floats do not hold the sides of such boxes to a pixel, so that they are drawn in another way.
TEST(LeastShape2D, OfALongOrFarRodIsInOnePiece) {
  Alone<2> near;
  EXPECT_GE(near.pixels_of(brick_at<2>({{6, 3.003F}}, 100)), 300);
  EXPECT_GE(near.pixels_of(brick_at<2>({{6, 3.003F}}, 1e6F)), 300);
  Alone<2> far(100000);
  EXPECT_GE(far.pixels_of(brick_at<2>({{100006, 100003}})), 1);
}

/// All of a body is widened by what a pixel is at its middle: a floor would rise before it.
TEST(LeastShape3D, LeavesFloorsAndLongRodsAsTheyAre) {
  EXPECT_FALSE(least_shape(body_of<3>({}, Brick<3>{{{500, 0, 500}}}, {{500, 0, 500}}), 0.5));
  EXPECT_FALSE(least_shape(brick_at<3>({}, 100), 0.5));
  EXPECT_TRUE(least_shape(brick_at<3>({}, 10), 0.5));
}

TEST(LeastShape2D, OfAnOutlineLiesWhereItsCornersAre) {
  Body<2> body;
  body.pose.position = {{1, 2}};
  body.pose.axes = {{{{0, 1}}, {{-1, 0}}}};  // turned by a quarter: the corner (5, 0) is at (1, 7)
  body.shape = Outline{{{{5, 0}}, {{5.01F, 0}}, {{5, 0.01F}}}};
  body.box = {{{0.99F, 7}}, {{1, 7.01F}}};
  const auto shape = least_shape(body, 0.5);
  ASSERT_TRUE(shape);
  Vector<2> middle;
  for (const Vector<2>& corner : std::get<Outline>(*shape).corners) middle = middle + corner * 0.25F;
  EXPECT_NEAR(middle[0], 5.005, 1e-5);
  EXPECT_NEAR(middle[1], 0.005, 1e-5);
}

}  // namespace
}  // namespace kerf::test
