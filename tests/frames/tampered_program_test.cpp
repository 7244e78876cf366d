#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <functional>

#include "core/recording/compression.h"
#include "tests/frames/program.h"
#include "tests/support/recorded_crowd.h"
#include "tests/support/tampering.h"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;

constexpr std::uint32_t kKeyframe = 256;

/// The most that a command may use to read a file of a megabyte.
constexpr std::uint64_t kMemory = std::uint64_t{2} << 30U;
constexpr std::uint64_t kSeconds = 60;

using State = BspState<2>;
using Nodes = std::vector<Node<2>>;

void with_nodes(State& state, const std::function<void(Nodes&)>& change) {
  Nodes nodes = state.tree.nodes();
  change(nodes);
  state.tree.assign(std::move(nodes), state.tree.unused(), state.tree.root());
}

Node<2>& some_leaf(Nodes& nodes) {
  return *std::ranges::find_if(nodes,
                               [](const Node<2>& node) { return node.alive && !node.entries.empty(); });
}

Node<2>& some_inner(Nodes& nodes) {
  return *std::ranges::find_if(nodes, [](const Node<2>& node) { return node.alive && !node.is_leaf(); });
}

/// A block that claims four gigabytes.
Bytes boastful_block() {
  Bytes frame = compress(Bytes(100'000, 1));
  std::fill_n(frame.begin() + 5, 4, 0xF0);
  frame.resize(20);
  return frame;
}

/// One way to spoil a recording; what is read of it is never right afterwards.
struct Damage {
  const char* name;
  std::function<void(const test::TemporaryRecording&)> make;
};

std::function<void(const test::TemporaryRecording&)> sql(const char* text) {
  return [text](const test::TemporaryRecording& file) { file.change(text); };
}
std::function<void(const test::TemporaryRecording&)> keyframe(const std::function<void(State&)>& change) {
  return [change](const test::TemporaryRecording& file) {
    test::forge_keyframe<2>(file.path(), kKeyframe, change);
  };
}
std::function<void(const test::TemporaryRecording&)> nodes(const std::function<void(Nodes&)>& change) {
  return keyframe([change](State& state) { with_nodes(state, change); });
}

const std::vector<Damage>& all_damage() {
  static const std::vector<Damage> all{
      {"ParentOutOfRange", nodes([](Nodes& n) { some_leaf(n).parent = NodeId{4'000'000'000}; })},
      {"Cycle", nodes([](Nodes& n) { some_inner(n).left = NodeId{0}; })},
      {"Depth", nodes([](Nodes& n) { some_leaf(n).depth = 4'000'000'000; })},
      {"Population", nodes([](Nodes& n) { some_leaf(n).population = 4'000'000'000; })},
      {"ManyObjects",
       [](const auto& file) {
         test::forge_keyframe(file.path(), kKeyframe, compress(Bytes(900'000, 0x80)));
       }},
      {"FourGigabytes", [](const auto& file) { test::forge_block(file.path(), 1, boastful_block()); }},
      {"ThirtyMillion",
       [](const auto& file) {
         test::forge_block(file.path(), 1, test::first_block_with_object<2>(file.path(), 30'000'000));
       }},
      {"EmptyBlocks", sql("UPDATE blocks SET data = x''")},
      {"TextForData", sql("UPDATE blocks SET data = 'none'")},
      {"NoBlocks", sql("DELETE FROM blocks")},
      {"NoSteps", sql("DELETE FROM steps")},
      {"NoMeta", sql("DELETE FROM meta")},
      {"RowsBehindAStep",
       sql("DELETE FROM steps WHERE step > 200; DELETE FROM blocks WHERE first_step > 200; "
           "DELETE FROM keyframes; DELETE FROM events WHERE step > 200")},
      {"HugeStep", sql("UPDATE steps SET step = 4000000000 WHERE step = 270")},
      {"HugeCounts", sql("UPDATE steps SET events = 9223372036854775807")},
      {"NegativeCounts", sql("UPDATE steps SET pairs = -1, objects = -1")},
      {"Words", sql("UPDATE steps SET height = 'high'")},
      {"Nulls", sql("UPDATE steps SET redundancy = NULL")},
      {"Infinity", sql("UPDATE steps SET place_seconds = 9e999")},
      {"ChangedFigure", sql("UPDATE steps SET pairs = pairs + 1 WHERE step = 17")},
      {"HugeBlock", sql("UPDATE blocks SET steps = 4294967295")},
      {"HugeKeyframe", sql("UPDATE keyframes SET step = 4294967295")},
      {"Dimension", sql("UPDATE meta SET value = '1000000' WHERE key = 'dimension'")},
      {"Directions", sql("UPDATE meta SET value = 'directions=4000000000' WHERE key = 'config'")},
      {"Endless",
       sql("DROP TABLE keyframes; CREATE VIEW keyframes AS WITH RECURSIVE r(x) AS (SELECT 1 UNION ALL "
           "SELECT x + 1 FROM r) SELECT x AS step, 1 AS seal, x AS data FROM r")},
      {"EndlessSteps",
       sql("DROP TABLE steps; CREATE VIEW steps AS WITH RECURSIVE r(x) AS (SELECT 1 UNION ALL "
           "SELECT x + 1 FROM r) SELECT x AS step FROM r")},
      {"Trigger", sql("CREATE TRIGGER t AFTER INSERT ON steps BEGIN DELETE FROM events; END")},
      {"OlderVersion", sql("PRAGMA user_version = 3")}};
  return all;
}

class TamperedProgram : public ::testing::TestWithParam<Damage> {};

std::vector<std::vector<std::string>> commands(const std::string& file, const std::filesystem::path& folder) {
  const std::string script = folder / "script";
  std::ofstream(script) << "key End\nwait 3\n";
  const std::string out = folder / "out.kerf";
  return {{"verify", file, "--oracle-every", "0"},
          {"explain", file, "--step", "270", "--node", "0"},
          {"explain", file, "--step", "270", "--pair", "1,2"},
          {"step", file, "--to", "step==270"},
          {"debug", file, "--headless", "--script", script},
          {"render", file, "--steps", "270", "--size", "64x64", "--out", folder / "frames"},
          {"compare", file, file},
          {"minimize", file, "--when", "step==3", "-o", out},
          {"export", file, "--boxes"},
          {"lint", file},
          {"advise", file, "--broad-phases", "kerf,columns", "--rounds", "2"},
          {"rerun", file, "--config", "max_height=20", "-o", out}};
}

/// Every command that reads a recording ends by itself, soon, without much memory, and says that something is
/// wrong, if it came by the damage.
TEST_P(TamperedProgram, EveryCommandEndsAndVerifySaysWhatIsWrong) {
  const test::TemporaryRecording file;
  test::record_crowd<2>(file.path(), kKeyframe + 20, test::busy_config());
  GetParam().make(file);
  for (const std::vector<std::string>& command : commands(file.path(), file.path().parent_path())) {
    const RunOutcome outcome = run_kerf(command, {.memory = kMemory, .seconds = kSeconds});
    EXPECT_LT(outcome.exit, 3) << command.front() << ": " << outcome.err;
    EXPECT_THAT(outcome.err, ::testing::Not(HasSubstr("not enough memory"))) << command.front();
    if (command.front() != "verify") continue;
    EXPECT_NE(outcome.exit, 0);
    EXPECT_THAT(outcome.err, ::testing::StartsWith("kerf: "));
  }
}

INSTANTIATE_TEST_SUITE_P(Damage, TamperedProgram, ::testing::ValuesIn(all_damage()),
                         [](const ::testing::TestParamInfo<Damage>& damage) {
                           return std::string(damage.param.name);
                         });

/// The same commands do something with a recording that is whole: a test that only sees refusals proves
/// nothing.
/// Another program's journal, and bytes that no page has.
TEST(TamperedProgram, WhatLiesBesideOrBehindARecordingIsNamed) {
  const test::TemporaryRecording file;
  test::record_crowd<2>(file.path(), 12, test::busy_config());
  const std::string journal = file.path().string() + "-journal";
  std::ofstream(journal) << std::string(5000, 'x');
  EXPECT_THAT(run_kerf({"verify", file.path()}).err,
              HasSubstr("crowd.kerf-journal: another program was changing"));
  std::filesystem::remove(journal);
  EXPECT_EQ(run_kerf({"verify", file.path()}).exit, 0);
  const auto size = std::filesystem::file_size(file.path());
  for (const auto& other : {size + 1, size - 1}) {
    std::filesystem::resize_file(file.path(), other);
    const RunOutcome outcome = run_kerf({"verify", file.path()});
    EXPECT_EQ(outcome.exit, 2) << outcome.out;
    EXPECT_THAT(outcome.err, HasSubstr("and the file has " + std::to_string(other)));
  }
}

TEST(TamperedProgram, WholeRecordingsAreRead) {
  const test::TemporaryRecording file;
  test::record_crowd<2>(file.path(), kKeyframe + 20, test::busy_config());
  for (const std::vector<std::string>& command : commands(file.path(), file.path().parent_path())) {
    const RunOutcome outcome = run_kerf(command, {.memory = kMemory, .seconds = kSeconds});
    const bool answers_no = command.front() == "lint" && outcome.exit == 1;
    EXPECT_TRUE(outcome.exit == 0 || answers_no) << command.front() << ": " << outcome.err;
    std::filesystem::remove(file.path().parent_path() / "out.kerf");
    std::filesystem::remove(file.path().parent_path() / "out.png");
    std::filesystem::remove(file.path().parent_path() / "out.cpp");
  }
}

}  // namespace
}  // namespace kerf::test
