// Imports of one step with very many pairs.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include "core/base/poll.h"
#include "core/files/part_file.h"
#include "frames/commands/exit_codes.h"
#include "frames/commands/memory_advice.h"
#include "frames/import/given_pairs.h"
#include "frames/support/errors.h"
#include "tests/frames/import_program.h"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class ImportHeap : public test::ImportProgram {
 protected:
  /// So many equal boxes, of whose pairs one was reported.
  [[nodiscard]] std::vector<std::string> import_of(int boxes) const {
    std::string lines = "step,object,min_x,max_x,min_y,max_y\n";
    for (int k = 0; k < boxes; ++k) lines += "1," + std::to_string(k) + ",0,1,0,1\n";
    return test::kerf_command({"import", write("heap.csv", lines), "--pairs",
                               write("pairs.csv", "step,a,b\n1,0,1\n"), "-o", path("a.kerf"), "--overwrite"});
  }
  [[nodiscard]] std::uintmax_t size_of_log(const std::string& name) const {
    const auto parts = parts_of(path(name));
    std::error_code none;
    const auto size = parts.empty() ? 0 : std::filesystem::file_size(parts.front().string() + "-wal", none);
    return none ? 0 : size;
  }
};

/// It writes 140 MB for its only step, and is interrupted when it has written 10.
TEST_F(ImportHeap, IsInterruptedWithinAStep) {
  (void)imported("a", write("small.csv", "step,object,min_x,max_x,min_y,max_y\n1,0,0,1,0,1\n"));
  const std::string before = test::read_text(path("a.kerf"));
  Process process(import_of(3000));
  ASSERT_TRUE(test::holds_within_a_minute([&] { return size_of_log("a.kerf") > 10'000'000; }));
  process.signal(SIGTERM);
  const RunOutcome outcome = process.wait();
  EXPECT_EQ(outcome.exit, kExitInterrupted);
  EXPECT_EQ(outcome.err, "kerf: interrupted: nothing was imported\n");
  EXPECT_TRUE(test::read_text(path("a.kerf")) == before);
  EXPECT_TRUE(parts_of(path("a.kerf")).empty());
}

TEST_F(ImportHeap, ReadingATableIsGivenUp) {
  const Polling polling([] { throw Stopped(); });
  Oddities oddities;
  EXPECT_THROW((void)read_given_pairs(write("pairs.csv", "step,a,b\n1,0,1\n"), oddities), Stopped);
}

TEST_F(ImportHeap, ARerunThatIsInterruptedWithinAStepIsKeptAsFarAsItCame) {
  ASSERT_EQ(Process(import_of(1500)).wait().exit, kExitHolds);
  Process process(test::kerf_command({"rerun", path("a.kerf"), "-o", path("again.kerf")}));
  ASSERT_TRUE(test::holds_within_a_minute([&] { return size_of_log("again.kerf") > 4'000'000; }));
  process.signal(SIGTERM);
  const RunOutcome outcome = process.wait();
  EXPECT_EQ(outcome.exit, kExitInterrupted);
  EXPECT_THAT(outcome.err, HasSubstr("interrupted: what was done is in " + path("again.kerf")));
  EXPECT_THAT(test::files_in(std::filesystem::path(path("a.kerf")).parent_path()),
              ::testing::UnorderedElementsAre("a.kerf", "again.kerf", "heap.csv", "pairs.csv"));
}

TEST_F(ImportHeap, WhereMemoryEndsSaysWhatNeedsLess) {
  const RunOutcome outcome = Process(import_of(6000), {.memory = std::uint64_t{400} << 20U}).wait();
  EXPECT_EQ(outcome.exit, kExitUnusable);
  EXPECT_THAT(outcome.err, HasSubstr("not enough memory; import fewer steps or fewer objects"));
  EXPECT_FALSE(std::filesystem::exists(path("a.kerf")));
}

TEST(OutOfMemory, PicturesAreNamedWhereOnesAreDrawn) {
  for (const ExitMeaning& of : exit_meanings()) {
    const std::string command(of.command);
    const std::string advice = out_of_memory(command);
    const bool draws = command == "render" || command == "collect" || command.starts_with("film") ||
                       command.ends_with("diff") || command == "debug" || command == "bench-frames";
    EXPECT_EQ(advice.find("smaller pictures") != std::string::npos, draws) << command;
    EXPECT_THAT(advice, ::testing::StartsWith("not enough memory; ")) << command;
  }
  EXPECT_THAT(out_of_memory("verify"), HasSubstr("--oracle-every 0"));
}

}  // namespace
}  // namespace kerf::test
