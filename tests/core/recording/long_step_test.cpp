// Work within a step can be given up.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <new>

#include "core/base/poll.h"
#include "core/replay/judge_theirs.h"
#include "core/replay/oracle.h"
#include "core/replay/verify.h"
#include "core/replay/what_if.h"
#include "tests/support/dimensions.h"
#include "tests/support/recorded_crowd.h"

namespace kerf {
namespace {

/// Gives work up that asks more often than that.
class Patience {
 public:
  explicit Patience(int most) : left_(most), polling_([this] { ask(); }) {}

 private:
  void ask() {
    if (left_-- <= 0) throw Stopped();
  }

  int left_;
  Polling polling_;
};

TEST(LongStep, AStatementIsGivenUp) {
  const test::TemporaryRecording file;
  const Database database = Database::create(file.path());
  const Patience patience(3);
  EXPECT_THROW((void)database.ask("WITH RECURSIVE n(x) AS (SELECT 1 UNION ALL SELECT x + 1 FROM n WHERE x < "
                                  "10000000) SELECT count(*) FROM n"),
               Stopped);
}

TEST(LongStep, ManyShortStatementsAreGivenUp) {
  const test::TemporaryRecording file;
  Database database = Database::create(file.path());
  database.execute("CREATE TABLE t(x INTEGER); BEGIN");
  Statement put = database.prepare("INSERT INTO t VALUES(?)");
  const Patience patience(3);
  const auto put_many = [&] {
    for (std::int64_t x = 0; x < 100'000; ++x) put.bind(1, x).run();
  };
  EXPECT_THROW(put_many(), Stopped);
}

/// The limit holds for the whole process, and can only fall.
TEST(LongStep, MemoryThatSqliteLacksIsMissingAsElsewhere) {
  const test::TemporaryRecording file;
  const auto ask_for_much = [&] {
    Database database = Database::create(file.path());
    database.execute("PRAGMA hard_heap_limit = 3000000");
    try {
      (void)database.ask("SELECT length(hex(randomblob(9000000)))");
    } catch (const std::bad_alloc&) {
      std::_Exit(3);
    }
  };
  EXPECT_EXIT(ask_for_much(), testing::ExitedWithCode(3), "");
}

template <class T>
class LongStep : public testing::Test {
 protected:
  static constexpr int kD = T::value;

  static ObjectTable<kD> heap(VolumeKind kind, std::uint32_t count) {
    ObjectTable<kD> objects(kind);
    for (std::uint32_t k = 0; k < count; ++k)
      (void)objects.insert({k}, enclose(box(), kind), Mobility::moving);
    return objects;
  }
  static Box<kD> box() {
    Box<kD> box;
    for (int axis = 0; axis < kD; ++axis) box.max[axis] = 1;
    return box;
  }
  /// One step, of whose pairs the other engine has reported none.
  void record_heap() const {
    const Config config;
    const RecordingInfo info = test::info_of<kD>(config);
    Bsp<kD, EventLog> tree(config);
    Recorder<kD> recorder(tree, path(), info);
    for (std::uint32_t k = 0; k < 200; ++k) (void)recorder.insert({k}, box(), Mobility::moving);
    recorder.step();
    recorder.add_theirs({}, judge_theirs<kD>({}, oracle_pairs(tree.objects()), tree.objects(),
                                             TheirWorld<kD>(), info.design));
    recorder.finish();
  }
  [[nodiscard]] std::filesystem::path path() const { return file_.path(); }

 private:
  test::TemporaryRecording file_;
};
TYPED_TEST_SUITE(LongStep, test::Dimensions, test::DimensionNames);

TYPED_TEST(LongStep, TheOracleIsGivenUp) {
  for (const VolumeKind kind : {VolumeKind::box, VolumeKind::sphere}) {
    const auto objects = this->heap(kind, 300);
    const Patience patience(3);
    EXPECT_THROW((void)oracle_pairs(objects), Stopped) << to_string(kind);
  }
}

TYPED_TEST(LongStep, TheOracleFindsEachPairOnceInOrder) {
  for (const VolumeKind kind : {VolumeKind::box, VolumeKind::sphere})
    for (const std::uint32_t count : {0U, 1U, 63U, 64U, 65U, 200U}) {
      std::vector<Pair> all;
      for (std::uint32_t a = 0; a < count; ++a)
        for (std::uint32_t b = a + 1; b < count; ++b) all.push_back({{a}, {b}});
      EXPECT_EQ(oracle_pairs(this->heap(kind, count)), all) << to_string(kind) << ", " << count;
    }
}

TYPED_TEST(LongStep, TheJudgementIsGivenUp) {
  const auto objects = this->heap(VolumeKind::box, 20);
  const std::vector<Pair> truth = oracle_pairs(objects);
  const Patience patience(3);
  EXPECT_THROW(
      (void)judge_theirs<TestFixture::kD>({}, truth, objects, TheirWorld<TestFixture::kD>(), PairDesign()),
      Stopped);
}

TYPED_TEST(LongStep, VerifyLeavesItOut) {
  this->record_heap();
  int asked = 0;
  const Verdict whole = verify(this->path(), 1, [&](std::uint32_t step) { return ++asked, step <= 2; });
  EXPECT_EQ(whole.steps, 1U);
  ASSERT_GT(asked, 10);
  for (const int last : {1, asked / 2, asked - 1}) {
    int left = last;
    const Verdict verdict = verify(this->path(), 1, [&](std::uint32_t /*step*/) { return left-- > 0; });
    EXPECT_EQ(verdict.steps + verdict.events + verdict.pairs, 0U);
    EXPECT_TRUE(std::ranges::count(verdict.unchecked, "steps 1 to 1") == 1) << last;
  }
}

TYPED_TEST(LongStep, ARerunKeepsWhatWasCommitted) {
  this->record_heap();
  RecordingReader<TestFixture::kD> reader(this->path());
  const test::TemporaryRecording again;
  int left = 10;
  EXPECT_FALSE(rerun(reader, reader.info(), again.path(), [&] { return left-- <= 0; }));
  const RecordingReader<TestFixture::kD> part(again.path());
  EXPECT_FALSE(part.info().complete);
  EXPECT_EQ(part.steps(), 0U);
  std::filesystem::remove(again.path());
  EXPECT_TRUE(rerun(reader, reader.info(), again.path(), [] { return false; }));
}

}  // namespace
}  // namespace kerf
