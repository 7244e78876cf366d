#include "core/recording/block_codec.h"

#include <gtest/gtest.h>

#include <bit>
#include <limits>
#include <stdexcept>
#include <string>

#include "core/base/random.h"
#include "core/recording/compression.h"
#include "core/recording/event_codec.h"
#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"

namespace kerf {
namespace {

template <class T>
class BlockCodec : public testing::Test {};
TYPED_TEST_SUITE(BlockCodec, test::Dimensions, test::DimensionNames);

template <int D>
std::vector<std::uint32_t> bits_of(const StepRequests<D>& requests) {
  std::vector<std::uint32_t> bits;
  for (const Box<D>& box : requests.boxes) {
    for (int axis = 0; axis < D; ++axis) {
      bits.push_back(std::bit_cast<std::uint32_t>(box.min[axis]));
      bits.push_back(std::bit_cast<std::uint32_t>(box.max[axis]));
    }
  }
  for (const Scalar x : requests.extra) bits.push_back(std::bit_cast<std::uint32_t>(x));
  return bits;
}

/// Of steps without events.
std::vector<StepRow> quiet_rows(std::size_t steps) {
  std::vector<StepRow> rows(steps);
  for (std::size_t k = 0; k < steps; ++k) rows[k].step = static_cast<std::uint32_t>(k + 1);
  return rows;
}

template <int D>
std::vector<RecordedStep<D>> there_and_back(VolumeKind kind, const std::vector<StepRequests<D>>& steps,
                                            std::size_t block_size) {
  BlockEncoder<D> encoder(kind);
  BlockDecoder<D> decoder(kind);
  std::vector<RecordedStep<D>> read;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    encoder.add(steps[k], {});
    if ((k + 1) % block_size == 0) decoder.read(encoder.take(), quiet_rows(block_size), read);
  }
  return read;
}

TYPED_TEST(BlockCodec, EveryBitPatternComesBack) {
  constexpr int kD = TypeParam::value;
  Random random(1);
  const auto any_float = [&] { return std::bit_cast<Scalar>(static_cast<std::uint32_t>(random.bits())); };
  std::vector<StepRequests<kD>> steps(20);
  for (StepRequests<kD>& step : steps) {
    for (std::uint32_t id = 0; id < 30; ++id) {
      Box<kD> box;
      for (int axis = 0; axis < kD; ++axis) {
        box.min[axis] = any_float();
        box.max[axis] = any_float();
      }
      step.add_move({id * 3}, box);
    }
    step.add_move({1}, test::slab<kD>(-0.0F, std::numeric_limits<Scalar>::denorm_min()));
    step.add_move({1}, test::slab<kD>(std::numeric_limits<Scalar>::quiet_NaN(),
                                      std::numeric_limits<Scalar>::infinity()));
  }
  const auto read = there_and_back(VolumeKind::box, steps, 5);
  ASSERT_EQ(read.size(), steps.size());
  for (std::size_t k = 0; k < steps.size(); ++k) {
    EXPECT_EQ(read[k].requests.calls, steps[k].calls);
    EXPECT_EQ(read[k].requests.objects, steps[k].objects);
    EXPECT_EQ(bits_of(read[k].requests), bits_of(steps[k])) << "in step " << k;
  }
}

TYPED_TEST(BlockCodec, EveryKindOfCallAndVolumeComesBack) {
  constexpr int kD = TypeParam::value;
  for (const VolumeKind kind : volume_kinds<kD>()) {
    Random random(2);
    std::vector<StepRequests<kD>> steps(4);
    for (StepRequests<kD>& step : steps) {
      const auto volume = [&] { return enclose(test::random_box<kD>(random, 9, 2), kind); };
      step.add_insert({7}, volume(), Mobility::fixed);
      step.add_insert({8}, volume().box, Mobility::moving);
      step.add_move({7}, volume());
      step.add_move({8}, volume().box);
      const std::vector<ObjectId> moved{{8}, {7}};
      const std::vector<Box<kD>> boxes{volume().box, volume().box};
      step.add_moves(moved, boxes);
      step.add_moves(moved, boxes);
      step.add_remove({7});
    }
    const auto read = there_and_back(kind, steps, 2);
    ASSERT_EQ(read.size(), steps.size());
    for (std::size_t k = 0; k < steps.size(); ++k) {
      EXPECT_EQ(read[k].requests.calls, steps[k].calls);
      EXPECT_EQ(read[k].requests.objects, steps[k].objects);
      EXPECT_EQ(read[k].requests.extra, steps[k].extra);
    }
  }
}

/// DESIGN.md: at most 14 bytes for each box that changed (24 raw), nothing for one that did not.
TYPED_TEST(BlockCodec, FlightIsCheapAndRestCostsNothing) {
  constexpr int kD = TypeParam::value;
  const auto cost = [](double speed) {
    Random random(3);
    BlockEncoder<kD> encoder(VolumeKind::box);
    std::vector<Vector<kD>> centers;
    for (int k = 0; k < 500; ++k) centers.push_back(test::random_point<kD>(random, 0, 50));
    std::size_t bytes = 0;
    std::uint64_t changed = 0;
    for (int step = 0; step < 40; ++step) {
      StepRequests<kD> requests;
      for (std::uint32_t id = 0; id < centers.size(); ++id) {
        centers[id] = centers[id] + test::random_point<kD>(random, 0, speed);
        requests.add_move({id}, test::box_at<kD>(centers[id], 0.5F));
      }
      const std::uint64_t now = encoder.add(requests, {});
      const std::size_t size = encoder.take().size();
      if (step < 10) continue;  // motion must be learnt
      changed += now;
      bytes += size;
    }
    return std::pair(changed, bytes);
  };
  const auto [moved, bytes] = cost(0.1);
  EXPECT_EQ(moved, 15000U);
  EXPECT_LT(static_cast<double>(bytes), 14.0 * static_cast<double>(moved));
  const auto [rested, least] = cost(0);
  EXPECT_EQ(rested, 0U);
  EXPECT_LT(least, 30U * 120U);  // thirty blocks' frames, and nothing for 15,000 boxes
}

TYPED_TEST(BlockCodec, DamageIsNoticed) {
  constexpr int kD = TypeParam::value;
  Random random(4);
  StepRequests<kD> step;
  for (std::uint32_t id = 0; id < 50; ++id) step.add_move({id}, test::random_box<kD>(random, 9, 1));
  BlockEncoder<kD> encoder(VolumeKind::box);
  encoder.add(step, {});
  const Bytes block = encoder.take();
  std::size_t noticed = 0;
  for (std::size_t k = 0; k < block.size(); k += 7) {
    Bytes damaged = block;
    damaged[k] ^= 0x10U;
    std::vector<RecordedStep<kD>> read;
    try {
      BlockDecoder<kD>(VolumeKind::box).read(damaged, quiet_rows(1), read);
      EXPECT_EQ(read.front().requests, step) << "at byte " << k;  // a bit that says nothing
    } catch (const std::runtime_error&) {
      ++noticed;
    }
  }
  EXPECT_GT(noticed, block.size() / 8);
  std::vector<RecordedStep<kD>> read;
  EXPECT_THROW(
      BlockDecoder<kD>(VolumeKind::box).read(std::span(block).first(block.size() / 2), quiet_rows(1), read),
      std::runtime_error);
}

/// A block of two million steps, or a step of so many events, took hundreds of bytes for each.
TEST(EventCodec, RoomIsMadeForWhatTheRowSaysOnly) {
  constexpr std::size_t kMany = 2'000'000;
  const Bytes zeros(kMany, 0);
  const auto block_of = [](std::size_t steps, const Bytes& calls, const Bytes& events) {
    ByteWriter block;
    block.varint(steps);
    for (const Bytes& column : {calls, Bytes(), events}) block.blob(column);
    return compress(block.bytes());
  };
  const auto complaint = [](const Bytes& block) {
    std::vector<RecordedStep<2>> read;
    try {
      BlockDecoder<2>(VolumeKind::box).read(block, quiet_rows(1), read);
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(complaint(block_of(kMany, zeros, zeros)),
            "the recording is damaged: it has other steps than its row says");
  ByteWriter events;
  events.varint(kMany / 2);
  for (const std::uint8_t zero : zeros) events.u8(zero);
  ByteReader reader(events.bytes());
  EXPECT_THROW((void)get_events(reader, quiet_rows(1).front()), std::runtime_error);
}

TEST(EventCodec, EveryKindOfEventComesBack) {
  const std::vector<Event> events{
      {40, 7, PhaseBegan{Phase::operate}},
      {41, 7, ObjectPlaced{{12}, 3}},
      {42, 7, OperatorScheduled{Operator::merge, {{5}, 2}}},
      {43, 7, OperatorActed{Operator::shift_split, {{6}, 1}, {10, 0, 0}, {10, 6, 5}, 3, 0.5F, -1.25F}},
      {44, 7, OperatorRefused{Operator::swap, {{9}, 0}, Refusal::entries}},
      {45, 7, EventsDeferred{4}},
      {46, 7, AllPlaced{1000}}};
  ByteWriter writer;
  put_events(events, writer);
  ByteReader reader(writer.bytes());
  StepRow row;
  row.step = 7;
  row.first_event = 40;
  row.events = events.size();
  EXPECT_EQ(get_events(reader, row), events);
}

}  // namespace
}  // namespace kerf
