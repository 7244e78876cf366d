#include "frames/commands/exit_codes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <sstream>

#include "frames/support/errors.h"
#include "tests/frames/program.h"
#include "tests/support/recorded_crowd.h"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;

/// Files of every kind that commands take, whole and damaged. A word of a command that begins with @ is one
/// of them, or one to be written.
class ExitCodes : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder.emplace();
    make("record pile -o @a.kerf --steps 20 --objects 20");
    make("record pile -o @b.kerf --steps 20 --objects 20 --seed 2");
    make(
        "record pile -o @waits.kerf --steps 100 --objects 200 --grow 60 --config "
        "min_threshold=8,max_threshold=16");
    test::record_another_run<2>(path("other.kerf"), 20);
    make("render @a.kerf --steps 1:6 --size 64x64 --out @frames");
    make("render @a.kerf --steps 1:6 --size 64x64 --out @shard --shard 1/2");
    make("render @b.kerf --steps 1:3 --size 64x64 --out @fewer");
    write("boxes.csv", "step,object,min_x,max_x,min_y,max_y\n1,0,0,1,0,1\n1,1,0,1,0,1\n");
    write("pairs.csv", "step,a,b\n");
    make("import @boxes.csv --pairs @pairs.csv -o @missed.kerf");
    write("bad.csv", "1,0,zero,1,0,1\n");
    write("holds", "key End\nexpect step == 20\n");
    write("fails", "key End\nexpect step == 7\n");
    write("broken", "click \"nothing of that name\"\n");
    write(
        "study.json",
        R"({"matrices": [{"motions": "uniform", "dimensions": 2, "objects": 20, "warm_up": 1, "steps": 2}]})");
    make("study @study.json --shard 1/2 --out @shards");
    damage();
  }
  static void TearDownTestSuite() { folder.reset(); }

  static RunOutcome run(const std::string& line) {
    std::vector<std::string> arguments;
    std::istringstream words(line);
    for (std::string word; words >> word;)
      arguments.push_back(word.starts_with("@") ? path(word.substr(1)).string() : word);
    return run_kerf(arguments);
  }
  static std::filesystem::path path(const std::string& name) { return folder->path() / name; }
  static void make(const std::string& line) {
    const RunOutcome outcome = run(line);
    ASSERT_EQ(outcome.exit, kExitHolds) << line << "\n" << outcome.err;
  }
  static void write(const std::string& name, const std::string& text) {
    std::ofstream(path(name), std::ios::binary) << text;
  }

 private:
  /// Recordings cut short, empty, of another version, and what is none at all.
  static void damage() {
    const std::string whole = read_text(path("a.kerf"));
    write("half.kerf", whole.substr(0, whole.size() / 2));
    write("fifty.kerf", whole.substr(0, 50));
    write("empty.kerf", "");
    constexpr std::size_t kVersionAt = 60;  // SQLite's user_version, big-endian
    std::string other = whole;
    other.replace(kVersionAt, 4, std::string("\0\0\0\x63", 4));
    write("version.kerf", other);
  }

  static std::optional<TemporaryFolder> folder;
};

std::optional<TemporaryFolder> ExitCodes::folder;

struct Case {
  int exit;
  const char* line;
};

/// Every subcommand with each of its codes, except 130.
constexpr Case kCases[] = {
    {0, "scenes"},
    {2, "scenes --no"},
    {0, "man"},
    {2, "man --no"},
    {0, "completion bash"},
    {2, "completion csh"},
    {0, "record pile -o @r.kerf --steps 3 --objects 3"},
    {2, "record pile -o @none/r.kerf --steps 3 --objects 3"},
    {0, "import @boxes.csv -o @i.kerf"},
    {2, "import @bad.csv -o @i2.kerf"},
    {0, "rerun @a.kerf -o @rerun.kerf --config min_threshold=4,max_threshold=8"},
    {2, "rerun @none.kerf -o @rerun2.kerf"},
    {0, "verify @a.kerf"},
    {1, "verify @other.kerf"},
    {0, "verify @a.kerf --oracle-every 0"},
    {2, "verify @a.kerf --oracle-every 1000"},
    {2, "verify @none.kerf"},
    {0, "debug @a.kerf --headless --script @holds"},
    {1, "debug @a.kerf --headless --script @fails"},
    {2, "debug @a.kerf --headless --script @broken"},
    {0, "step @a.kerf --to step==3"},
    {1, "step @a.kerf --to step==300"},
    {2, "step @a.kerf --to stp==3"},
    {2, "step @a.kerf --to step==3 --picture @picture.txt"},
    {2, "step @a.kerf --to pair(3,3)"},
    {0, "explain @a.kerf --pair 0,1"},
    {2, "explain @none.kerf --pair 0,1"},
    {2, "explain @a.kerf --ray 0,1"},
    {0, "compare @a.kerf @a.kerf"},
    {1, "compare @a.kerf @b.kerf"},
    {2, "compare @a.kerf @none.kerf"},
    {0, "lint @a.kerf"},
    {1, "lint @waits.kerf --within 1"},
    {2, "lint @none.kerf"},
    {0, "minimize @missed.kerf --when pairs>0 -o @small.kerf"},
    {1, "minimize @a.kerf --when step>300 -o @small2.kerf"},
    {2, "minimize @a.kerf --when stp>3 -o @small3.kerf"},
    {0, "export @a.kerf --csv"},
    {0, "export @a.kerf --csv -o -"},
    {2, "export @a.kerf --csv -o @none/a.csv"},
    {0, "render @a.kerf --steps 1:2 --size 64x64 --out @r"},
    {2, "render @a.kerf --steps 1:2 --size 0x0 --out @r2"},
    {2, "render @a.kerf --steps 1:2 --size 64x64 --show contacts --out @r2"},
    {0, "collect @frames"},
    {1, "collect @shard"},
    {2, "collect @none"},
    {0, "diff @frames @frames"},
    {1, "diff @frames @shard"},
    {2, "diff @frames @none"},
    {0, "film @a.kerf -o @story.gif --seconds 2 --fps 5 --size 640x360"},
    {2, "film @none.kerf -o @story2.gif"},
    {0, "film-diff @frames @frames -o @f.gif"},
    {1, "film-diff @frames @fewer -o @f2.gif"},
    {2, "film-diff @frames @none -o @f3.gif"},
    {0, "advise @a.kerf --broad-phases kerf,columns --rounds 2"},
    {2, "advise @none.kerf"},
    {0, "bench --scenes falling --objects 50 --algorithms kerf --rounds 1 --steps 3 --warm-up 1"},
    {0, "bench --queries --scenes uniform --objects 50 --rounds 1 --warm-up 1"},
    {2, "bench --queries --threads 2"},
    {2, "bench --scenes fallin"},
    {0, "bench-frames --sizes 320x240 --boxes 10"},
    {2, "bench-frames --sizes 64x64 --boxes 5 --frames 600 --json @none/a.json"},
    {0, "doctor"},
    {1, "doctor --room 1000000"},
    {2, "doctor --no"},
    {0, "experiment --steps 60 --objects 60 --out @experiment"},
    {2, "experiment --steps none --out @experiment2"},
    {0, "report volumes --objects 20 --steps 10 --rounds 1 --seeds 1 --out @page.html"},
    {2, "report nothing --out @page2.html"},
    {0, "study @study.json --out @study"},
    {1, "study @study.json --join @shards --out @joined"},
    {2, "study @none.json"},
};

TEST_F(ExitCodes, EveryCommandHasItsCodes) {
  for (const Case& each : kCases) {
    const RunOutcome outcome = run(each.line);
    EXPECT_EQ(outcome.exit, each.exit) << each.line << "\n" << outcome.err;
    EXPECT_EQ(outcome.err.empty(), each.exit == 0) << each.line;
  }
}

/// Whatever is asked of it, a file that cannot be read is no answer.
TEST_F(ExitCodes, ADamagedRecordingIsUnusableForEveryCommand) {
  for (const char* command :
       {"verify F", "step F --to step==3", "explain F --pair 0,1", "explain F --node n0", "compare F @a.kerf",
        "compare @a.kerf F", "lint F", "minimize F --when step==3 -o @m.kerf", "export F --csv",
        "export F --boxes -o @e.csv", "render F --steps 1:2 --size 64x64 --out @d",
        "debug F --headless --script @holds", "rerun F -o @d.kerf", "advise F"}) {
    for (const char* name : {"half", "fifty", "empty", "version", "none"}) {
      std::string line = command;
      line.replace(line.find('F'), 1, "@" + std::string(name) + ".kerf");
      const RunOutcome outcome = run(line);
      EXPECT_EQ(outcome.exit, kExitUnusable) << line << "\n" << outcome.out << outcome.err;
      EXPECT_THAT(outcome.err, HasSubstr(std::string(name) + ".kerf")) << line;
    }
  }
}

/// Texts and tables that commands read: where F stands they are given what is none. The message is ours, not
/// that of a library's stream.
TEST_F(ExitCodes, WhatIsNoTextIsRefusedByName) {
  std::filesystem::create_directory(path("folder.x"));
  write("zeros.x", std::string(300, '\0'));
  write("utf16.x", std::string("\xFF\xFE{\0}\0", 6));
  for (const char* command :
       {"debug @a.kerf --headless --script F", "render @a.kerf --camera-path F --out @d",
        "render pile --camera-path F --steps 1:2 --out @d", "study F --out @d", "import F -o @d.kerf",
        "import @boxes.csv --pairs F -o @d.kerf", "import @boxes.csv --objects F -o @d.kerf",
        "import @boxes.csv --ignore F --pairs @pairs.csv -o @d.kerf",
        "import @boxes.csv --structure F -o @d.kerf"}) {
    for (const std::string name : {"folder.x", "zeros.x", "utf16.x", "none/missing.x"}) {
      std::string line = command;
      line.replace(line.find('F'), 1, "@" + name);
      const RunOutcome outcome = run(line);
      EXPECT_EQ(outcome.exit, kExitUnusable) << line << "\n" << outcome.out << outcome.err;
      EXPECT_THAT(outcome.err, HasSubstr(name)) << line;
      EXPECT_THAT(outcome.err, ::testing::Not(HasSubstr("basic_"))) << line;
    }
  }
}

/// A folder that has the name of a file which an earlier run could have left.
TEST_F(ExitCodes, AFolderInThePlaceOfAFileIsNamed) {
  const auto expect_named = [](const std::string& line, const std::string& file) {
    const RunOutcome outcome = run(line);
    EXPECT_EQ(outcome.exit, kExitUnusable) << line;
    EXPECT_THAT(outcome.err, HasSubstr(file + ": Is a directory")) << line;
  };
  std::filesystem::create_directories(path("of_frames/frames.json"));
  expect_named("collect @of_frames", "frames.json");
  expect_named("film-diff @of_frames @frames -o @f4.gif", "frames.json");
  const std::string cell = test::files_in(path("shards")).front();
  std::filesystem::create_directories(path("of_study/" + cell));
  expect_named("study @study.json --out @of_study", cell);
}

/// A command without a case is found, as is a case of a code that the command does not have.
TEST_F(ExitCodes, NoCommandIsLeftOut) {
  for (const ExitMeaning& meaning : exit_meanings()) {
    for (const int code : {kExitHolds, kExitDoesNotHold, kExitUnusable}) {
      const bool has = std::ranges::any_of(kCases, [&](const Case& each) {
        return each.exit == code &&
               (std::string(each.line) + " ").starts_with(std::string(meaning.command) + " ");
      });
      EXPECT_EQ(has, code != kExitDoesNotHold || !meaning.does_not_hold.empty())
          << meaning.command << " " << code;
    }
  }
}

TEST_F(ExitCodes, AreInTheHelp) {
  for (const ExitMeaning& meaning : exit_meanings())
    EXPECT_THAT(run(std::string(meaning.command) + " --help").out, HasSubstr(exit_help(meaning.command)))
        << meaning.command;
}

}  // namespace
}  // namespace kerf::test
