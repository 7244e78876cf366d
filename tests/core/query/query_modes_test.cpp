// What is said of a recording is the same where the caller's processor takes denormals for zero.

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/query/compare.h"
#include "core/query/explain_pair.h"
#include "core/query/history.h"
#include "core/query/search.h"
#include "core/query/structure_check.h"
#include "tests/hard/flush_to_zero.h"
#include "tests/support/dimensions.h"
#include "tests/support/recorded_crowd.h"

namespace kerf {
namespace {

constexpr Scalar kTiny = 0x1p-140F;  // a denormal

template <int D>
Box<D> box_along_x(Scalar min, Scalar max) {
  Box<D> box;
  for (int axis = 0; axis < D; ++axis) box.max[axis] = 1;
  box.min[0] = min;
  box.max[0] = max;
  return box;
}

/// Two boxes that lie a denormal apart, or that touch.
template <int D>
std::shared_ptr<RecordingReader<D>> record_two(const std::filesystem::path& path, Scalar between) {
  Bsp<D, EventLog> tree(test::busy_config());
  Recorder<D> recorder(tree, path, test::info_of<D>(tree.config()));
  (void)recorder.insert({0}, box_along_x<D>(0, kTiny), Mobility::moving);
  (void)recorder.insert({1}, box_along_x<D>(kTiny + between, 1), Mobility::moving);
  recorder.step();
  recorder.finish();
  return std::make_shared<RecordingReader<D>>(path);
}

/// A box that ends there along x.
template <int D>
std::shared_ptr<RecordingReader<D>> record_import(const std::filesystem::path& path, double end) {
  RecordingInfo info = test::info_of<D>(test::busy_config());
  info.imported = true;
  GivenBox<D> given = to_given(box_along_x<D>(0, 0));
  given.max[0] = end;
  Bsp<D, EventLog> tree(info.config);
  Recorder<D> recorder(tree, path, info);
  (void)recorder.insert({0}, round_outward(given), Mobility::moving);
  recorder.step();
  recorder.add_theirs(TheirChanges<D>{{{{0}, given}}, {}});
  recorder.finish();
  return std::make_shared<RecordingReader<D>>(path);
}

template <class T>
class QueryModes : public testing::Test {
 private:
  test::TemporaryRecording apart_file_;
  test::TemporaryRecording touching_file_;

 protected:
  const std::shared_ptr<RecordingReader<T::value>> apart_ = record_two<T::value>(apart_file_.path(), kTiny);
  const std::shared_ptr<RecordingReader<T::value>> touching_ = record_two<T::value>(touching_file_.path(), 0);
};
TYPED_TEST_SUITE(QueryModes, test::Dimensions, test::DimensionNames);

TYPED_TEST(QueryModes, BoxesADenormalApartAreNoPair) {
  const Pair pair{{0}, {1}};
  Replayer<TypeParam::value> replayer(this->apart_);
  replayer.seek(1);
  const test::FlushToZero flush(true);
  const auto why = explain_pair(replayer, 1, pair);
  EXPECT_FALSE(why.is_pair || why.reported || why.boxes_overlap);
  EXPECT_TRUE(why.history.empty());
  EXPECT_TRUE(pair_history(*this->apart_, pair, 1).empty());
  EXPECT_EQ(to_text(why, this->apart_->info()).find("overlap on"), std::string::npos);
  Search<TypeParam::value> search(this->apart_);
  EXPECT_FALSE(search.value(Expression::parse("missed > 0 || extra > 0"), Position::end_of(1)).is_true());
  EXPECT_FALSE(search.forward(Expression::parse("missed > 0"), Position{0, 0}));
  EXPECT_FALSE(search.backward(Expression::parse("missed > 0"), Position::end_of(2)));
}

/// Floats are compared bit by bit, and what imports have in doubles as numbers.
TYPED_TEST(QueryModes, ADenormalIsADifferenceBetweenImports) {
  constexpr int kD = TypeParam::value;
  const test::TemporaryRecording one;
  const test::TemporaryRecording two;
  const auto a = record_import<kD>(one.path(), 0x1p-1040);
  const auto b = record_import<kD>(two.path(), 0x1p-1041);
  const test::FlushToZero flush(true);
  EXPECT_EQ(compare(*a, *b).requests, 1U);
}

TYPED_TEST(QueryModes, AnObjectADenormalOutsideOfItsCellIsAFault) {
  constexpr int kD = TypeParam::value;
  StructureParts<kD> parts;
  parts.cells.push_back({.box = box_along_x<kD>(kTiny, 1)});
  parts.members.push_back({0, {0}});
  const std::vector<KnownObject<kD>> objects{{{0}, box_along_x<kD>(0, 1)}};
  const test::FlushToZero flush(true);
  const auto faults = check_structure<kD>(parts, objects, {});
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].kind, StructureFaultKind::object_outside_cell);
}

}  // namespace
}  // namespace kerf
