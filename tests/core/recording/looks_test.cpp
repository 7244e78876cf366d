#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/recording/compression.h"
#include "core/recording/look_codec.h"
#include "core/recording/shape_rows.h"
#include "core/scene/pose_in_box.h"
#include "tests/support/boxes.h"
#include "tests/support/crowd_shapes.h"
#include "tests/support/dimensions.h"
#include "tests/support/recorded_crowd.h"

namespace kerf {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

template <class T>
class LooksOf : public testing::Test {};
TYPED_TEST_SUITE(LooksOf, test::Dimensions, test::DimensionNames);

/// The most that any axis is off.
template <int D>
double distance(const std::array<Vector<D>, D>& a, const std::array<Vector<D>, D>& b) {
  double most = 0;
  for (std::size_t k = 0; k < D; ++k) most = std::max(most, double{length(a[k] - b[k])});
  return most;
}

TYPED_TEST(LooksOf, ATurnIsRoundedAsLittleAsItSays) {
  constexpr int kD = TypeParam::value;
  EXPECT_EQ(turn_of<kD>(identity_axes<kD>()), Turn<kD>());
  double most = 0;
  for (double angle = -7; angle < 7; angle += 0.0137) {
    const auto axes = test::turned_axes<kD>(angle);
    const Turn<kD> turn = turn_of<kD>(axes);
    most = std::max(most, distance<kD>(axes_of(turn), axes));
  }
  EXPECT_LE(most, 0x1p-10);
  EXPECT_GT(most, 0x1p-16);
}

/// Half turns about each axis and about diagonals: where the quaternion's first component is zero.
TEST(Turn, HalfTurnsComeBack) {
  const std::vector<std::array<Vector<3>, 3>> half_turns{{Vector<3>{{1, 0, 0}}, {{0, -1, 0}}, {{0, 0, -1}}},
                                                         {Vector<3>{{-1, 0, 0}}, {{0, 1, 0}}, {{0, 0, -1}}},
                                                         {Vector<3>{{-1, 0, 0}}, {{0, -1, 0}}, {{0, 0, 1}}},
                                                         {Vector<3>{{0, 1, 0}}, {{1, 0, 0}}, {{0, 0, -1}}},
                                                         {Vector<3>{{0, 0, -1}}, {{0, -1, 0}}, {{-1, 0, 0}}}};
  for (const auto& axes : half_turns) EXPECT_LE(distance<3>(axes_of(turn_of<3>(axes)), axes), 0x1p-10);
}

/// Objects that turn, change their shape, go and come again, over blocks and a restart.
template <int D>
std::vector<StepRequests<D>> some_requests() {
  constexpr std::uint32_t kObjects = 9;
  std::vector<StepRequests<D>> steps(40);
  for (std::uint32_t step = 0; step < steps.size(); ++step)
    for (std::uint32_t id = 0; id < kObjects; ++id) {
      if (step == 0) steps[step].add_insert({id}, Box<D>{}, Mobility::moving);
      if (step > 0 && (step + id) % 4 != 0) steps[step].add_move({id}, Box<D>{});
      if (step % 11 == 7 && id == step % kObjects) steps[step].add_remove({id});
      if (step % 11 == 9 && id == (step - 2) % kObjects)
        steps[step].add_insert({id}, Box<D>{}, Mobility::moving);
    }
  return steps;
}

template <int D>
Look<D> look_at(ObjectId object, std::uint32_t step) {
  if (object.value == 8) return {};
  const double speed = 0.03 * object.value * (1 + 0.1 * std::sin(0.3 * step));
  Look<D> look{
      (object.value + step / 25) % 5, turn_of<D>(test::turned_axes<D>(object.value + speed * step)), {}};
  if (object.value % 3 == 1) look.stretch[1] = static_cast<std::int16_t>(50 * std::sin(0.2 * step));
  return look;
}

template <int D>
std::vector<Look<D>> looks_at(const StepRequests<D>& requests, std::uint32_t step) {
  std::vector<Look<D>> looks;
  for (const ObjectId object : requests.objects) looks.push_back(look_at<D>(object, step));
  return looks;
}

TYPED_TEST(LooksOf, ComeBackAsTheyWere) {
  constexpr int kD = TypeParam::value;
  const auto steps = some_requests<kD>();
  LookEncoder<kD> encoder;
  LookDecoder<kD> decoder;
  Looks<kD> expected;
  Looks<kD> read;
  std::size_t changes = 0;
  for (std::uint32_t first = 0; first < steps.size(); first += 8) {
    if (first == 16) {  // a keyframe
      encoder.restart(encoder.looks());
      decoder.restart(read);
    }
    std::vector<Looks<kD>> after;
    for (std::uint32_t step = first; step < first + 8; ++step) {
      encoder.add(steps[step], looks_at(steps[step], step));
      std::size_t k = 0;
      for (const Call& call : steps[step].calls)
        for (std::uint32_t n = 0; n < call.count; ++n, ++k) {
          const ObjectId object = steps[step].objects[k];
          expected.set(object, call.kind == RequestKind::remove ? Look<kD>() : look_at<kD>(object, step));
        }
      after.push_back(expected);
    }
    ByteWriter block;
    encoder.take(block);
    ByteReader in(block.bytes());
    decoder.open(in);
    for (std::uint32_t step = first; step < first + 8; ++step) {
      const auto changed = decoder.read(steps[step]);
      changes += changed.size();
      read.apply(changed);
      ASSERT_EQ(read, after[step - first]) << "step " << step;
    }
    EXPECT_TRUE(decoder.empty());
    EXPECT_TRUE(in.empty());
  }
  EXPECT_GT(changes, 150U);
  EXPECT_EQ(encoder.looks(), read);
  EXPECT_EQ(decode_looks<kD>(encode_looks(read), 9), read);
  EXPECT_TRUE(encode_looks(Looks<kD>()).empty());
}

/// What turns evenly is foretold: less than two bytes for each rotation.
TYPED_TEST(LooksOf, EvenRotationsCostLittle) {
  constexpr int kD = TypeParam::value;
  constexpr std::uint32_t kObjects = 50;
  constexpr std::uint32_t kRows = 25;
  LookEncoder<kD> encoder;
  for (std::uint32_t step = 0; step < kRows; ++step) {
    StepRequests<kD> requests;
    std::vector<Look<kD>> looks;
    for (std::uint32_t id = 0; id < kObjects; ++id) {
      requests.add_move({id}, Box<kD>{});
      looks.push_back({0, turn_of<kD>(test::turned_axes<kD>(id + (0.01 + 0.004 * id) * step)), {}});
    }
    encoder.add(requests, looks);
  }
  ByteWriter block;
  encoder.take(block);
  EXPECT_LT(compress(block.bytes()).size(), (kD == 2 ? 1 : 2) * kObjects * kRows);
}

TYPED_TEST(LooksOf, BlocksWithoutLooksHaveNone) {
  constexpr int kD = TypeParam::value;
  LookEncoder<kD> encoder;
  LookDecoder<kD> decoder;
  for (const auto& requests : some_requests<kD>()) encoder.add(requests, {});
  ByteWriter block;
  encoder.take(block);
  ByteReader in(block.bytes());
  decoder.open(in);
  for (const auto& requests : some_requests<kD>()) EXPECT_TRUE(decoder.read(requests).empty());
  EXPECT_TRUE(decoder.empty());
}

/// Any byte changed, and any end cut off: refused, or looks that are rotations.
TYPED_TEST(LooksOf, DamagedOnesAreRefusedOrStillRotations) {
  constexpr int kD = TypeParam::value;
  const auto steps = some_requests<kD>();
  LookEncoder<kD> encoder;
  for (std::uint32_t step = 0; step < steps.size(); ++step)
    encoder.add(steps[step], looks_at(steps[step], step));
  ByteWriter block;
  encoder.take(block);
  const Bytes whole(block.bytes().begin(), block.bytes().end());
  Random random(kD);
  int refused = 0;
  for (int attempt = 0; attempt < 500; ++attempt) {
    Bytes bytes = whole;
    if (attempt % 10 == 0) bytes.resize(random.below(static_cast<std::uint32_t>(bytes.size())));
    if (!bytes.empty()) {
      std::uint8_t& byte = bytes[random.below(static_cast<std::uint32_t>(bytes.size()))];
      byte = static_cast<std::uint8_t>(byte ^ (1U << random.below(8)));
    }
    try {
      LookDecoder<kD> decoder;
      ByteReader in(bytes);
      decoder.open(in);
      for (const auto& requests : steps)
        for (const LookChange<kD>& change : decoder.read(requests))
          for (const Vector<kD>& axis : axes_of(change.look.turn)) EXPECT_NEAR(length(axis), 1, 1e-5);
    } catch (const std::runtime_error& error) {
      EXPECT_THAT(error.what(), HasSubstr("damaged"));
      ++refused;
    }
  }
  EXPECT_GT(refused, 50);
}

/// Three components whose squares are more than one leave none for the fourth.
TEST(Turn, ThatCannotBeIsRefused) {
  EXPECT_THAT(
      [] {
        (void)make_turn<3>(0, {}, {4'000, 4'000, 0});
      },
      ThrowsMessage<std::runtime_error>(HasSubstr("turned as nothing can be")));
  EXPECT_THAT(
      [] {
        (void)make_turn<3>(0, {}, {100'000, 0, 0});
      },
      ThrowsMessage<std::runtime_error>(HasSubstr("turned as nothing can be")));
  EXPECT_EQ(make_turn<2>(0, {32'000}, {1'000}).parts[0], -32'536) << "angles wrap around";
}

TYPED_TEST(LooksOf, AKeyframeHasNoLooksOfObjectsThatItDoesNotHave) {
  constexpr int kD = TypeParam::value;
  Looks<kD> looks;
  looks.set({7}, {3, {}, {}});
  EXPECT_EQ(decode_looks<kD>(encode_looks(looks), 8), looks);
  EXPECT_THAT([&] { (void)decode_looks<kD>(encode_looks(looks), 7); },
              ThrowsMessage<std::runtime_error>(HasSubstr("objects that it does not have")));
}

TYPED_TEST(LooksOf, OnlyBricksOfNearlyOneSizeAreStretched) {
  constexpr int kD = TypeParam::value;
  const Brick<kD> base{test::all<kD>(2)};
  Brick<kD> wide = base;
  wide.half[1] = 2.3F;
  const auto stretch = stretch_between<kD>(base, wide);
  ASSERT_TRUE(stretch);
  EXPECT_EQ((*stretch)[0], 0);
  EXPECT_NEAR(std::get<Brick<kD>>(stretched<kD>(base, *stretch)).half[1], 2.3, 2 * 0x1p-10);
  EXPECT_EQ(stretched<kD>(Ball{1}, *stretch), Shape<kD>(Ball{1}));
  EXPECT_FALSE(stretch_between<kD>(Ball{1}, Ball{1.1F}));
  EXPECT_FALSE(stretch_between<kD>(base, Ball{1.1F}));
  for (const Scalar half : {1.0F, 4.0F, std::nanf("")}) {
    wide.half[1] = half;
    EXPECT_FALSE(stretch_between<kD>(base, wide)) << half;
  }
}

template <int D>
bool same_shape(const Shape<D>& a, const Shape<D>& b) {
  return encode_shape<D>(a) == encode_shape<D>(b);
}

TYPED_TEST(LooksOf, EveryKindOfShapeComesBack) {
  constexpr int kD = TypeParam::value;
  const auto shapes = test::all_shapes<kD>(1.25F);
  EXPECT_EQ(shapes.size(), std::variant_size_v<Shape<kD>>);
  ShapeNumbers<kD> numbers;
  for (const Shape<kD>& shape : shapes) {
    const ShapeText text = encode_shape<kD>(shape);
    const Shape<kD> read = decode_shape<kD>(text.kind, text.data);
    EXPECT_EQ(read.index(), shape.index());
    EXPECT_TRUE(same_shape<kD>(read, shape)) << text.kind;
    EXPECT_EQ(numbers.number_of(shape), numbers.number_of(read)) << text.kind;
  }
  EXPECT_EQ(numbers.take_new().size(), shapes.size());
  EXPECT_TRUE(numbers.take_new().empty());
  EXPECT_EQ(count_shapes<kD>(std::vector{shapes[0], shapes[1], shapes[1]}), "1 ball, 2 bricks");
}

TYPED_TEST(LooksOf, WhatIsNoShapeIsRefused) {
  constexpr int kD = TypeParam::value;
  const auto said = [](std::string_view kind, const ByteWriter& data) -> std::string {
    try {
      (void)decode_shape<kD>(kind, data.bytes());
      return "";
    } catch (const std::runtime_error& error) {
      return error.what();
    }
  };
  ByteWriter nothing;
  EXPECT_THAT(said("ball", nothing), HasSubstr("too soon"));
  EXPECT_THAT(said("cone", nothing), HasSubstr("no shape 'cone'"));
  EXPECT_THAT(said(kD == 2 ? "surface" : "outline", nothing), HasSubstr("no shape"));
  for (const float radius : {0.0F, -1.0F, std::numeric_limits<float>::infinity(), std::nanf("")}) {
    ByteWriter data;
    data.f32(radius);
    EXPECT_THAT(said("ball", data), HasSubstr("a size of"));
  }
  ByteWriter long_ball;
  for (int k = 0; k < 4; ++k) long_ball.f32(1);
  EXPECT_THAT(said("ball", long_ball), HasSubstr("more numbers"));
}

TEST(ShapeRows, ARoomOfCornersIsNotTakenOnTrust) {
  ByteWriter outline;
  outline.varint(1'000'000'000);
  outline.f32(1);
  EXPECT_THAT([&] { (void)decode_shape<2>("outline", outline.bytes()); },
              ThrowsMessage<std::runtime_error>(HasSubstr("longer than its block")));
  EXPECT_THAT([&] { (void)decode_shape<3>("surface", compress(outline.bytes())); },
              ThrowsMessage<std::runtime_error>(HasSubstr("longer than its block")));
  ByteWriter two_corners;
  two_corners.varint(2);
  for (int k = 0; k < 4; ++k) two_corners.f32(static_cast<float>(k));
  EXPECT_THAT([&] { (void)decode_shape<2>("outline", two_corners.bytes()); },
              ThrowsMessage<std::runtime_error>(HasSubstr("2 corners")));
  ByteWriter nowhere;
  nowhere.varint(3);
  for (int k = 0; k < 6; ++k) nowhere.f32(std::nanf(""));
  EXPECT_THAT([&] { (void)decode_shape<2>("outline", nowhere.bytes()); },
              ThrowsMessage<std::runtime_error>(HasSubstr("nowhere")));
  ByteWriter pointless;
  pointless.varint(1);
  for (int k = 0; k < 3; ++k) pointless.f32(0);
  pointless.varint(1);
  for (const int corner : {0, 0, 1}) pointless.varint(static_cast<std::uint64_t>(corner));
  EXPECT_THAT([&] { (void)decode_shape<3>("surface", compress(pointless.bytes())); },
              ThrowsMessage<std::runtime_error>(HasSubstr("without a corner")));
}

}  // namespace
}  // namespace kerf
