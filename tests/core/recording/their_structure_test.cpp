// Another engine's structure in a recording: it comes back as it was, recordings without one are what they
// were before there were any, and changes are seen.

#include "core/recording/their_structure.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "core/recording/recording_reader.h"
#include "core/replay/what_if.h"
#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"
#include "tests/support/recorded_crowd.h"

namespace kerf::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

/// Nodes with everything that a node can say, and with nothing of it.
template <int D>
TheirStructure<D> structure_of(std::uint32_t step) {
  TheirStructure<D> structure;
  structure.nodes.resize(2);
  structure.nodes[0].name = {true, 9'000'000'000'000'000'000U};
  structure.nodes[0].box = {test::all<D>(0), test::all<D>(1)};
  structure.nodes[1].name = GivenId::of(step);
  structure.nodes[1].parent = structure.nodes[0].name;
  structure.nodes[1].box = structure.nodes[0].box;
  structure.nodes[1].box.max[0] = std::numeric_limits<Scalar>::infinity();
  structure.nodes[1].objects = {{3}, {100'000}};
  structure.nodes[1].leaf = true;
  structure.nodes[1].margin = 0.25F;
  return structure;
}

template <class T>
class TheirStructures : public testing::Test {
 protected:
  static constexpr int kDimension = T::value;

  /// An import whose steps from `first` on have a structure.
  void record(std::uint32_t first) {
    Bsp<kDimension, EventLog> tree(test::busy_config());
    RecordingInfo info = test::info_of<kDimension>(test::busy_config());
    info.imported = true;
    info.digits = digits_;
    Recorder<kDimension> recorder(tree, file_.path(), info);
    test::play_crowd<kDimension>(recorder, 8, 3, [&](std::uint32_t step) {
      if (step >= first) recorder.add_theirs(structure_of<kDimension>(step));
    });
    recorder.finish();
  }
  [[nodiscard]] std::int64_t version() const {
    return Database::open(file_.path()).ask("PRAGMA user_version");
  }

  TemporaryRecording file_;
  std::optional<TheirDigits> digits_;
};
TYPED_TEST_SUITE(TheirStructures, test::Dimensions, test::DimensionNames);

TYPED_TEST(TheirStructures, ComeBackAsTheyWere) {
  constexpr int kD = TestFixture::kDimension;
  this->record(5);
  EXPECT_EQ(this->version(), kStructureVersion);
  const RecordingReader<kD> reader(this->file_.path());
  EXPECT_THAT(reader.structure_steps(), ElementsAre(5, 6, 7, 8));
  EXPECT_EQ(reader.their_structure(4), std::nullopt);
  for (std::uint32_t step = 5; step <= 8; ++step)
    EXPECT_EQ(reader.their_structure(step), structure_of<kD>(step)) << step;
  for (std::uint32_t step = 1; step <= 8; ++step) EXPECT_NO_THROW(reader.check_theirs(step)) << step;
}

TYPED_TEST(TheirStructures, ARecordingWithoutOneHasTheVersionOfBefore) {
  constexpr int kD = TestFixture::kDimension;
  this->record(99);
  EXPECT_EQ(this->version(), 7);
  const RecordingReader<kD> reader(this->file_.path());
  EXPECT_TRUE(reader.structure_steps().empty());
  EXPECT_EQ(reader.their_structure(3), std::nullopt);
}

TYPED_TEST(TheirStructures, AreKeptByARerun) {
  constexpr int kD = TestFixture::kDimension;
  this->record(2);
  RecordingReader<kD> reader(this->file_.path());
  const TemporaryRecording again;
  ASSERT_TRUE(rerun(reader, reader.info(), again.path()));
  EXPECT_EQ(RecordingReader<kD>(again.path()).their_structure(7), structure_of<kD>(7));
}

TYPED_TEST(TheirStructures, SayHowTheirNumbersWereWritten) {
  constexpr int kD = TestFixture::kDimension;
  this->digits_ = TheirDigits{{9, 3}, {6, 12}};
  this->record(2);
  RecordingReader<kD> reader(this->file_.path());
  EXPECT_EQ(reader.info().digits, this->digits_);
  EXPECT_EQ(reader.their_structure(3)->digits, this->digits_);
  const TemporaryRecording again;
  ASSERT_TRUE(rerun(reader, reader.info(), again.path()));
  EXPECT_EQ(RecordingReader<kD>(again.path()).info().digits, this->digits_);
}

TYPED_TEST(TheirStructures, ChangesAreSeen) {
  constexpr int kD = TestFixture::kDimension;
  this->record(5);
  this->file_.change(
      "UPDATE their_structures SET data = (SELECT data FROM their_structures WHERE step = 6) WHERE step = 7");
  const RecordingReader<kD> reader(this->file_.path());
  EXPECT_EQ(reader.their_structure(6), structure_of<kD>(6));
  EXPECT_THAT([&] { static_cast<void>(reader.their_structure(7)); },
              ThrowsMessage<std::runtime_error>(HasSubstr("what step 7 has of another engine")));
  this->file_.change("DELETE FROM their_structures WHERE step = 8");
  EXPECT_THROW(RecordingReader<kD>(this->file_.path()).check_theirs(8), std::runtime_error);
  this->file_.change("DROP TABLE their_structures");
  EXPECT_THAT([&] { RecordingReader<kD>{this->file_.path()}; },
              ThrowsMessage<std::runtime_error>(HasSubstr("it lacks what was made by")));
}

TEST(TheirStructure, DamagedBytesAreRefused) {
  TheirStructure<2> structure = structure_of<2>(1);
  structure.nodes[0].box.min[0] = std::numeric_limits<Scalar>::quiet_NaN();
  EXPECT_THAT([&] { static_cast<void>(decode_structure<2>(encode_structure(structure))); },
              ThrowsMessage<std::runtime_error>(HasSubstr("a bound that is no number")));
  structure = structure_of<2>(1);
  structure.nodes[1].margin = -1;
  EXPECT_THAT([&] { static_cast<void>(decode_structure<2>(encode_structure(structure))); },
              ThrowsMessage<std::runtime_error>(HasSubstr("a margin of the other engine is no length")));
  EXPECT_THROW(static_cast<void>(decode_structure<3>(encode_structure(structure_of<2>(1)))),
               std::runtime_error);
}

}  // namespace
}  // namespace kerf::test
