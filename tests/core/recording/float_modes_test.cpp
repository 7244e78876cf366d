// Recordings are the same however the threads that write and read them round, and take denormals.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cfenv>
#include <cstring>
#include <memory>
#include <vector>

#include "core/base/config.h"
#include "core/base/random.h"
#include "core/query/explain_event.h"
#include "core/query/explain_node.h"
#include "core/query/explain_query.h"
#include "core/query/expression.h"
#include "core/query/text.h"
#include "core/recording/recorder.h"
#include "core/recording/recording_reader.h"
#include "core/replay/cursor.h"
#include "core/replay/verify.h"
#include "tests/hard/flush_to_zero.h"
#include "tests/support/dimensions.h"
#include "tests/support/recorded_crowd.h"

namespace kerf {
namespace {

struct CallerMode {
  const char* name;
  int rounding;
  bool flushes;
};
constexpr std::array<CallerMode, 5> kCallerModes = {{{"usual", FE_TONEAREST, false},
                                                     {"up", FE_UPWARD, false},
                                                     {"down", FE_DOWNWARD, false},
                                                     {"toward zero", FE_TOWARDZERO, false},
                                                     {"denormals are zero", FE_TONEAREST, true}}};

class InCallerMode {
 public:
  explicit InCallerMode(const CallerMode& mode) : flush_(mode.flushes) { std::fesetround(mode.rounding); }
  ~InCallerMode() { std::fesetround(FE_TONEAREST); }
  InCallerMode(const InCallerMode&) = delete;
  InCallerMode& operator=(const InCallerMode&) = delete;

 private:
  test::FlushToZero flush_;
};

constexpr std::uint32_t kGivenObjects = 40;
constexpr std::uint32_t kGivenSteps = 40;

template <int D>
using GivenBoxes = std::vector<Box<D>>;

/// GivenBoxes that move evenly, by step; half of them so small that all of their bounds are denormals.
template <int D>
std::vector<GivenBoxes<D>> given_boxes() {
  Random random(7);
  GivenBoxes<D> boxes(kGivenObjects);
  GivenBoxes<D> ways(kGivenObjects);
  std::vector<GivenBoxes<D>> all;
  for (std::uint32_t step = 0; step < kGivenSteps; ++step) {
    for (std::uint32_t k = 0; k < kGivenObjects; ++k) {
      const double size = k % 2 == 0 ? 1 : 1e-40;
      for (int axis = 0; axis < D; ++axis) {
        if (step == 0) {
          boxes[k].min[axis] = static_cast<Scalar>(size * random.uniform(-5, 5));
          boxes[k].max[axis] = boxes[k].min[axis] + static_cast<Scalar>(size * random.uniform(0.1, 1));
          ways[k].min[axis] = static_cast<Scalar>(size * random.uniform(-0.1, 0.1));
        }
        boxes[k].min[axis] += ways[k].min[axis];
        boxes[k].max[axis] += ways[k].min[axis];
      }
    }
    all.push_back(boxes);
  }
  return all;
}

template <int D>
void record_in(const std::vector<GivenBoxes<D>>& given, const std::filesystem::path& path,
               const CallerMode& mode) {
  std::vector<ObjectId> objects;
  for (std::uint32_t k = 0; k < kGivenObjects; ++k) objects.push_back({k});
  const InCallerMode caller(mode);
  Bsp<D, EventLog> tree(test::busy_config());
  Recorder<D> recorder(tree, path, test::info_of<D>(tree.config()));
  for (const GivenBoxes<D>& boxes : given) {
    for (const ObjectId object : objects)
      if (tree.steps() == 0) (void)recorder.insert(object, boxes[object.index()], Mobility::moving);
    if (tree.steps() > 0) (void)recorder.move_many(objects, boxes);
    recorder.step();
  }
  recorder.finish();
}

template <int D>
std::vector<GivenBoxes<D>> read_in(const std::filesystem::path& path, const CallerMode& mode) {
  const InCallerMode caller(mode);
  std::vector<GivenBoxes<D>> all;
  RecordingReader<D> reader(path);
  for (std::uint32_t step = 1; step <= reader.steps(); ++step)
    all.push_back(reader.step(step).requests.boxes);
  return all;
}

/// Denormals are equal to zero where a processor takes them for that.
template <int D>
bool are_same_bits(const std::vector<GivenBoxes<D>>& a, const std::vector<GivenBoxes<D>>& b) {
  return std::ranges::equal(a, b, [](const GivenBoxes<D>& x, const GivenBoxes<D>& y) {
    return x.size() == y.size() && std::memcmp(x.data(), y.data(), x.size() * sizeof(Box<D>)) == 0;
  });
}

template <class T>
class RecordedModes : public testing::Test {};
TYPED_TEST_SUITE(RecordedModes, test::Dimensions, test::DimensionNames);

TYPED_TEST(RecordedModes, BoxesComeBackBitByBit) {
  constexpr int kD = TypeParam::value;
  const auto given = given_boxes<kD>();
  for (const CallerMode& writer : kCallerModes) {
    const test::TemporaryRecording file;
    record_in<kD>(given, file.path(), writer);
    for (const CallerMode& reader : kCallerModes) {
      EXPECT_TRUE(are_same_bits<kD>(read_in<kD>(file.path(), reader), given))
          << "written: " << writer.name << ", read: " << reader.name;
      const InCallerMode caller(reader);
      EXPECT_TRUE(verify(file.path()).holds()) << "written: " << writer.name << ", read: " << reader.name;
    }
  }
}

TYPED_TEST(RecordedModes, ACursorSeesTheSameStatesAndCandidates) {
  constexpr int kD = TypeParam::value;
  const test::TemporaryRecording file;
  test::record_crowd<kD>(file.path(), 40, test::busy_config());
  const auto look = [&](const CallerMode& mode) {
    const InCallerMode caller(mode);
    Cursor<kD> cursor(std::make_shared<RecordingReader<kD>>(file.path()));
    std::vector<std::uint64_t> seen;
    cursor.go_to_step(1);
    while (cursor.forward(Granularity::op) && cursor.position().step < 30) {
      seen.push_back(cursor.state().hash());
      for (const BallotEntry& entry : cursor.candidates())
        seen.push_back(std::uint64_t{entry.direction} << 32U | std::bit_cast<std::uint32_t>(entry.offset));
    }
    return seen;
  };
  const auto usual = look(kCallerModes[0]);
  EXPECT_GT(usual.size(), 20U);
  for (const CallerMode& mode : kCallerModes) EXPECT_EQ(look(mode), usual) << mode.name;
}

/// Texts of floats were written as the caller rounds, and denormals as 0.
TYPED_TEST(RecordedModes, SentencesAreTheSame) {
  constexpr int kD = TypeParam::value;
  const test::TemporaryRecording file;
  const auto given = given_boxes<kD>();
  record_in<kD>(given, file.path(), kCallerModes[0]);
  const auto look = [&](const CallerMode& mode) {
    const InCallerMode caller(mode);
    Replayer<kD> replayer(std::make_shared<RecordingReader<kD>>(file.path()));
    const GivenNames names;
    std::string text = number_text(0.65000049999) + "\n";
    for (std::uint64_t event = 0; event < 200; ++event)
      text += to_text(explain_event(replayer, event), names);
    for (const std::uint32_t node : {0U, 1U, 2U}) text += to_text(explain_node(replayer, 20, {node}), names);
    for (const char* const query : {"sphere 0.1,0.1,0.3", "ray 0.1,0.1,0.7,0.3", "box 0,0,1e-40,1e-40"}) {
      if (kD == 3) break;
      text += to_text(explain_query(replayer, 20, parse_query<kD>(query)), names);
    }
    return text + to_text(explain_query(replayer, 20, AskedQuery<kD>(given[0][1])), names);
  };
  const std::string usual = look(kCallerModes[0]);
  EXPECT_NE(usual.find("candidates:"), std::string::npos);
  EXPECT_NE(usual.find("e-4"), std::string::npos) << "denormals";
  for (const CallerMode& mode : kCallerModes) EXPECT_EQ(look(mode), usual) << mode.name;
}

/// With a caller that rounds down, 0.1 was read as the double below.
TEST(TextInEveryMode, IsReadAsTheSameNumber) {
  Config usual;
  set(usual, "max_redundancy", "0.1");
  const GivenNames names({},
                         {"2024-05-01T12:00:00.001", "2024-05-01T12:00:00.016", "2024-05-01T12:00:00.033"});
  for (const CallerMode& mode : kCallerModes) {
    const InCallerMode caller(mode);
    Config config;
    set(config, "max_redundancy", "0.1");
    EXPECT_EQ(config, usual) << mode.name;
    EXPECT_EQ(Expression::parse("redundancy<10%").parts()[1].number.nearest, 0.1) << mode.name;
    for (std::uint32_t step = 1; step <= 3; ++step)
      EXPECT_EQ(names.find_step(names.step(step)), step) << mode.name;
  }
}

}  // namespace
}  // namespace kerf
