#include "tests/support/tampering.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <optional>

#include "core/files/whole_file.h"
#include "core/recording/compression.h"
#include "core/recording/database.h"
#include "core/recording/keyframe_codec.h"
#include "core/recording/recording_reader.h"
#include "core/recording/schema.h"
#include "core/replay/judge_theirs.h"
#include "core/replay/verify.h"
#include "tests/support/config_of.h"
#include "tests/support/crowd_shapes.h"
#include "tests/support/dimensions.h"
#include "tests/support/recorded_crowd.h"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;

constexpr std::uint32_t kKeyframe = 256;  ///< the only step with one

void write_bytes(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

/// Another engine's pairs: one is missed, and one invented.
std::vector<Pair> other_pairs(std::span<const Pair> pairs) {
  std::vector<Pair> others(pairs.begin(), pairs.end());
  if (!others.empty()) others.pop_back();
  others.push_back({{1000}, {1001}});
  return others;
}

/// What an import says of names and of what its engine leaves out.
void add_import(RecordingInfo& info) {
  std::vector<GivenId> objects;
  for (std::uint32_t k = 0; k <= 1001; ++k) objects.push_back(GivenId::of(7 * k + 3));
  std::vector<std::string> steps;
  for (std::uint32_t k = 1; k <= kKeyframe + 20; ++k) steps.push_back(std::to_string(5000 + k));
  info.imported = true;
  info.names = {std::move(objects), std::move(steps)};
  for (std::uint32_t k = 0; k < 4; ++k)
    info.marks.set({k}, {"wheel " + std::to_string(k), Rgb{200, static_cast<std::uint8_t>(k), 0}});
  info.design.ignored = {{{1}, {2}}, {{3}, {4}}};
}

/// A box in doubles and a filter, of objects that are there.
template <int D>
TheirChanges<D> changes_of(const ObjectTable<D>& objects, std::uint32_t step) {
  TheirChanges<D> changes;
  for (std::uint32_t k = 0; k < objects.bound() && changes.boxes.size() < 2; ++k)
    if (objects.is_placed({k})) changes.boxes.push_back({{k}, to_given(objects.box({k}))});
  for (const auto& change : changes.boxes) changes.filters.push_back({change.object, {step, UINT64_MAX}});
  return changes;
}

/// A recording with rows in every table: objects that come and go, with shapes, a keyframe, another
/// configuration from a step on, a decision, and another engine's pairs in the first steps.
template <int D>
void record_everything(const std::filesystem::path& path) {
  RecordingInfo info = test::info_of<D>(test::busy_config());
  kerf::apply(info.config, "byte_sweep=1,skin=4");
  info.changes.push_back({200, info.config});
  info.changes.back().config.min_balance = 0.4F;
  info.decisions.push_back({1'000'000, Operator::merge, std::nullopt});
  info.decisions.push_back({2'000'000, Operator::split, ChosenPlane{1, 0.5F}});
  add_import(info);
  Bsp<D, EventLog> tree(info.config, info.volume);
  Recorder<D> recorder(tree, path, info);
  TheirWorld<D> world;
  test::CrowdShapes<D> shapes(tree);
  recorder.show([&](ObjectId object) { return shapes.appearance(object); });
  test::play_crowd<D>(recorder, kKeyframe + 20, 1, [&](std::uint32_t step) {
    (void)tree.trace().take();
    if (step > 5) return;
    const std::vector<Pair> theirs = other_pairs(recorder.pairs());
    std::vector<Pair> truth(recorder.pairs().begin(), recorder.pairs().end());
    std::ranges::sort(truth);
    const TheirChanges<D> changes = changes_of(tree.objects(), step);
    world.apply(changes);
    recorder.add_theirs(changes);
    recorder.add_theirs(theirs, judge_theirs<D>(theirs, truth, tree.objects(), world, info.design));
  });
  recorder.finish();
}

/// What `verify` says against a recording; empty if it holds.
std::string objection(const std::filesystem::path& path) {
  try {
    const Verdict verdict = verify(path, 64);
    if (verdict.holds()) return "";
    if (verdict.change) return verdict.change->what;
    return verdict.divergence ? verdict.divergence->recorded : "wrong pairs";
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

template <class T>
class Tampering : public testing::Test {
 protected:
  static constexpr int kD = T::value;

  void SetUp() override {
    record_everything<kD>(path());
    whole_ = read_whole_file(path());
  }
  [[nodiscard]] std::filesystem::path path() const { return file_.path(); }
  void restore() const { write_bytes(path(), whole_); }
  void change(const std::string& sql) const { file_.change(sql); }

  /// Some value of that column; another row where the change would meet its equal.
  std::string change_any(const std::string& table, const std::string& column, Random& random) const {
    const std::uint32_t rows = test::rows_of(path(), table);
    for (int attempt = 0; attempt < 20; ++attempt) {
      const StoredValue value{table, column, random.below(rows)};
      try {
        test::change_value(path(), value, random);
      } catch (const std::runtime_error& error) {
        EXPECT_THAT(error.what(), HasSubstr("UNIQUE"));
        continue;
      }
      return to_string(value);
    }
    return "nothing";
  }

 private:
  TemporaryRecording file_;
  std::string whole_;
};
TYPED_TEST_SUITE(Tampering, test::Dimensions, test::DimensionNames);

TYPED_TEST(Tampering, NothingIsSaidAgainstWhatWasRecorded) {
  const Verdict verdict = verify(this->path());
  EXPECT_TRUE(verdict.holds()) << objection(this->path());
  EXPECT_EQ(verdict.keyframes, 1U);
  EXPECT_GT(verdict.theirs.pairs, 0U);
  EXPECT_THAT(verdict.unchecked, testing::ElementsAre(HasSubstr("how long"), HasSubstr("turned")));
  EXPECT_THAT(verify(this->path(), 10).unchecked, testing::Contains(HasSubstr("by the oracle")));
}

/// Rows of steps and of blocks that a complete recording does not have; no step asks for them.
TYPED_TEST(Tampering, AnAddedRowIsNoticed) {
  for (const std::string step : {"0", "999", "NULL"}) {
    const std::string rest = step + ", 0, 1";
    for (const std::string& row :
         {"events(step, id, node, generation, kind, op) VALUES(" + step + ", 100000, 0, 0, 'acted', 'split')",
          "their_pairs VALUES(" + rest + ")", "their_verdicts VALUES(" + rest + ", 'extra')",
          "their_filters VALUES(" + rest + ", 1)", "their_boxes(step, object) VALUES(" + step + ", 0)"}) {
      this->change("INSERT INTO " + row);
      EXPECT_THAT(objection(this->path()),
                  AnyOf(HasSubstr("has a row of no step"), HasSubstr("e100000 has figures")))
          << row;
      this->restore();
    }
  }
  for (const std::string row :
       {"their_steps VALUES(999, 1, 0, 0, 0, 0)", "blocks VALUES(999, 5, 3, 0, x'00')"}) {
    this->change("INSERT INTO " + row);
    EXPECT_THAT(objection(this->path()), HasSubstr("has a row of no step")) << row;
    this->restore();
  }
}

/// Every column of every table, each once or twice.
TYPED_TEST(Tampering, AnyChangedValueIsNoticed) {
  Random random(TestFixture::kD);
  int changes = 0;
  for (const std::string& table : test::tables_of(this->path()))
    for (const std::string& column : test::columns_of(this->path(), table))
      for (int k = 0; k < 2; ++k, ++changes) {
        this->restore();
        const std::string value = this->change_any(table, column, random);
        EXPECT_NE(objection(this->path()), "") << value;
      }
  EXPECT_GE(changes, 120);
}

TYPED_TEST(Tampering, ADeletedRowIsNoticed) {
  for (const std::string& table : test::tables_of(this->path()))
    for (const char* const which : {"min", "max"}) {
      this->restore();
      const std::string key = table == "meta" ? "key" : "rowid";
      this->change("DELETE FROM " + table + " WHERE " + key + " = (SELECT " + which + "(" + key + ") FROM " +
                   table + ")");
      EXPECT_NE(objection(this->path()), "") << which << " of " << table;
    }
}

TYPED_TEST(Tampering, RowsThatChangedPlacesAreNoticed) {
  const std::string swap = " SET %1 = -%1 WHERE %1 IN (2, 3); UPDATE %0 SET %1 = %1 + 5 WHERE %1 < 0";
  const auto swapped = [&](std::string table, const std::string& key) {
    std::string sql = "UPDATE " + table + swap;
    for (const auto& [mark, text] : {std::pair(std::string("%0"), table), std::pair(std::string("%1"), key)})
      for (std::size_t at = sql.find(mark); at != std::string::npos; at = sql.find(mark))
        sql.replace(at, 2, text);
    return sql;
  };
  for (const auto& [table, key] :
       {std::pair("steps", "step"), std::pair("their_steps", "step"), std::pair("their_pairs", "rowid")}) {
    this->restore();
    this->change(swapped(table, key));
    EXPECT_NE(objection(this->path()), "") << table;
  }
}

/// "complete" promises that nothing followed.
TYPED_TEST(Tampering, AnEndThatIsMissingIsNoticed) {
  this->change(
      "DELETE FROM steps WHERE step > 250; DELETE FROM blocks WHERE first_step > 250; "
      "DELETE FROM keyframes; DELETE FROM events WHERE step > 250");
  EXPECT_NE(objection(this->path()), "");
}

TYPED_TEST(Tampering, OtherCommandsRefuseAChangedFigure) {
  this->change("UPDATE steps SET pairs = pairs + 1 WHERE step = 17");
  EXPECT_THAT(objection(this->path()), HasSubstr("step 5017"));
  try {
    RecordingReader<TestFixture::kD>{this->path()};
    FAIL() << "it was opened";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("step 5017"));
    EXPECT_THAT(error.what(), HasSubstr("kerf verify"));
  }
}

TYPED_TEST(Tampering, NothingElseHasThePlaceOfATable) {
  const std::string endless =
      "WITH RECURSIVE r(x) AS (SELECT 1 UNION ALL SELECT x + 1 FROM r) SELECT x AS step, 1 AS seal, x AS "
      "data FROM r";
  for (const std::string& sql :
       {"DROP TABLE keyframes; CREATE VIEW keyframes AS " + endless,
        std::string("CREATE TRIGGER t AFTER INSERT ON steps BEGIN DELETE FROM events; END"),
        std::string("ALTER TABLE steps ADD COLUMN more INTEGER"), std::string("DROP TABLE their_pairs"),
        std::string("CREATE TABLE notes(x)"), std::string("DROP INDEX their_pairs_of_step"),
        std::string("DROP TABLE keyframes; CREATE VIRTUAL TABLE keyframes USING fts5(step, seal, data)")}) {
    this->restore();
    this->change(sql);
    EXPECT_THAT(objection(this->path()), testing::AnyOf(HasSubstr("no Kerf has made"), HasSubstr("lacks")))
        << sql;
  }
}

// What a forger writes, all hashes being right.

TYPED_TEST(Tampering, AForgedTreeIsRefused) {
  constexpr int kDimension = TestFixture::kD;
  using State = BspState<kDimension>;
  using Nodes = std::vector<Node<kDimension>>;
  const auto with_nodes = [](const std::function<void(Nodes&)>& change) {
    return std::function<void(State&)>([change](State& state) {
      Nodes nodes = state.tree.nodes();
      change(nodes);
      state.tree.assign(std::move(nodes), state.tree.unused(), state.tree.root());
    });
  };
  const auto inner = [](Nodes& nodes) -> Node<kDimension>& {
    return *std::ranges::find_if(nodes,
                                 [](const Node<kDimension>& node) { return node.alive && !node.is_leaf(); });
  };
  const auto leaf = [](Nodes& nodes) -> Node<kDimension>& {
    return *std::ranges::find_if(
        nodes, [](const Node<kDimension>& node) { return node.alive && node.entries.size() > 2; });
  };
  struct Forgery {
    const char* said;
    std::function<void(State&)> change;
  };
  const std::vector<Forgery> forgeries{
      {"parent link", with_nodes([&](Nodes& nodes) { leaf(nodes).parent = NodeId{4'000'000'000}; })},
      {"right-of mask", with_nodes([&](Nodes& nodes) { inner(nodes).left = inner(nodes).right; })},
      {"parent link", with_nodes([&](Nodes& nodes) { inner(nodes).left = NodeId{0}; })},
      {"the depth", with_nodes([&](Nodes& nodes) { leaf(nodes).depth = 4'000'000'000; })},
      {"population", with_nodes([&](Nodes& nodes) { leaf(nodes).population = 4'000'000'000; })},
      {"straddle mask", with_nodes([&](Nodes& nodes) { leaf(nodes).entries.front().straddle ^= 1; })},
      {"object has two", with_nodes([&](Nodes& nodes) { leaf(nodes).entries[0] = leaf(nodes).entries[1]; })},
      {"right-of mask", with_nodes([&](Nodes& nodes) { leaf(nodes).right_of ^= 1; })},
      {"alive but not", with_nodes([&](Nodes& nodes) { nodes.emplace_back().alive = true; })},
      {"waits", with_nodes([&](Nodes& nodes) { nodes.emplace_back(); })},
      {"a balance is listed",
       [](State& state) {
         state.scheduler.resume({{{{NodeId{0}, 0}}, {}, {}, {}, {}}}, state.scheduler.acted(), 0);
       }},
      {"not those that were asked", [](State& state) { (void)state.latest.remove(ObjectId{7}); }},
      {"configuration", [](State& state) { state.config.max_height = 7; }},
      {"number than its step", [](State& state) { ++state.step; }},
      {"last event", [](State& state) { ++state.next_event; }},
      {"placements", [](State& state) { ++state.placed; }},
      {"another state", [](State& state) { state.skins.resize(state.skins.size() + 1); }},
      {"another state",
       [](State& state) {
         const Mode mode = state.modes.mode();
         state.modes.resume(mode == Mode::swept ? Mode::kept : Mode::swept, state.modes.memory());
       }},
      {"another state", [](State& state) {
         state.modes.resume(state.modes.mode(), {1, 2, 3, 4});
       }}};
  for (const Forgery& forgery : forgeries) {
    this->restore();
    test::forge_keyframe<kDimension>(this->path(), kKeyframe, forgery.change);
    EXPECT_THAT(objection(this->path()), HasSubstr(forgery.said));
  }
}

TYPED_TEST(Tampering, NoBlockAsksForMoreThanItsBytesCanHold) {
  Bytes declares = compress(Bytes(100'000, 1));
  ASSERT_EQ(declares[4] & 0xC0U, 0x80U) << "the size has four bytes";
  for (std::size_t k = 0; k < 4; ++k) declares[5 + k] = 0xF0;
  declares.resize(20);
  test::forge_block(this->path(), 1, declares);
  EXPECT_THAT(objection(this->path()), HasSubstr("20 bytes says that it holds"));
  this->restore();
  test::forge_block(this->path(), 1,
                    test::first_block_with_object<TestFixture::kD>(this->path(), 30'000'000));
  EXPECT_THAT(objection(this->path()), HasSubstr("an object 30000000"));
}

/// Each node that is not alive takes two bytes, and some tens in memory.
TEST(Keyframe, HasNoMoreNodesThanItsBytesStandFor) {
  ByteWriter bytes;
  bytes.varint(0);  // objects
  bytes.text(to_string(busy_config()));
  bytes.varint(0);  // objects as they were placed
  constexpr std::size_t kNodes = 2'000'000;
  bytes.varint(kNodes);
  for (std::size_t k = 0; k < 2 * kNodes; ++k) bytes.u8(0);
  const auto projector = make_projector<2>(busy_config(), VolumeKind::box);
  EXPECT_THAT(
      [&] { (void)decode_keyframe<2>(compress(bytes.bytes()), projector); },
      ::testing::ThrowsMessage<std::runtime_error>(HasSubstr("bytes says that it has 2000000 nodes")));
}

/// By such an index SQL finds other rows than are there.
TYPED_TEST(Tampering, AnIndexThatDoesNotFitItsTableIsFound) {
  constexpr std::size_t kPageSize = 16'384;
  constexpr std::string_view kIndex =
      "SELECT rootpage FROM sqlite_master WHERE type = 'index' AND tbl_name = 'their_pairs'";
  const std::int64_t page = Database::open(this->path()).ask(kIndex);
  std::string bytes = read_whole_file(this->path());
  char& row = bytes.at(static_cast<std::size_t>(page) * kPageSize - 1);  // of the first entry
  row = static_cast<char>(row ^ 0x40);
  write_bytes(this->path(), bytes);
  EXPECT_THAT(objection(this->path()), HasSubstr("missing from index"));
}

/// A bomb: 64 MiB of zeros in some kilobytes are no block, however honest its header is.
TEST(Compression, WhatCompressesTooWellIsPaddedAndNotBelievedWithout) {
  const Bytes zeros(std::size_t{64} << 20U, 0);
  Bytes frame = compress(zeros);
  EXPECT_GE(frame.size(), zeros.size() / 300);
  EXPECT_LE(frame.size(), zeros.size() / 200);
  EXPECT_EQ(decompress(frame), zeros);
  frame.resize(frame.size() / 2);
  EXPECT_THROW((void)decompress(frame), std::runtime_error);
  const Bytes small(1000, 7);
  EXPECT_LT(compress(small).size(), 100U) << "what is small is not padded";
  EXPECT_EQ(compress(small, 500).size(), 500U);
  EXPECT_EQ(decompress(compress(small, 500)), small);
}

TEST(RecorderNumbers, AnObjectNumberFarAboveTheirCountIsRefusedAtOnce) {
  const TemporaryRecording file;
  Bsp<2, EventLog> tree(test::busy_config());
  Recorder<2> recorder(tree, file.path(), test::info_of<2>(tree.config()));
  (void)recorder.insert(ObjectId{300'000}, Box<2>{{0, 0}, {1, 1}}, Mobility::moving);
  EXPECT_THROW(recorder.step(), std::runtime_error);
}

}  // namespace
}  // namespace kerf::test
