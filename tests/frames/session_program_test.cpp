#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/frames/program.h"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// What a user noted in the debugger is never lost, whichever file is written over.
class SessionProgram : public ::testing::Test {
 protected:
  SessionProgram() { record("pile", 40); }

  void record(const std::string& scene, int steps) const {
    const RunOutcome outcome = run_kerf({"record", scene, "-o", path("v.kerf"), "--objects", "20", "--steps",
                                         std::to_string(steps), "--overwrite"});
    ASSERT_EQ(outcome.exit, 0) << outcome.err;
  }
  [[nodiscard]] std::string path(const std::string& name) const { return folder_.path() / name; }
  [[nodiscard]] RunOutcome play(const std::string& script, const std::string& session = "") const {
    std::ofstream(path("script")) << script;
    std::vector<std::string> words{"debug", path("v.kerf"), "--headless", "--script", path("script")};
    if (!session.empty()) words.insert(words.end(), {"--session", path(session)});
    return run_kerf(words);
  }
  [[nodiscard]] static std::string kept_as(const std::string& name) {
    return "the earlier session is kept as " + name + "\n";
  }

 private:
  TemporaryFolder folder_;
};

constexpr const char* kPrecious = "key End\nkey shift+b\ntype precious\nkey Enter\nsave session\n";

TEST_F(SessionProgram, ANoteBeyondTheEndOfANewRecordingIsKept) {
  ASSERT_EQ(play(kPrecious).exit, 0);
  const std::string noted = read_text(path("v.kerf.session"));
  record("pile", 20);
  const RunOutcome outcome = play("wait 3\n", "v.kerf.session");
  EXPECT_EQ(outcome.exit, 0);
  EXPECT_EQ(outcome.err, kept_as(path("v.kerf.session.earlier")));
  EXPECT_EQ(read_text(path("v.kerf.session.earlier")), noted);
  EXPECT_THAT(read_text(path("v.kerf.session")), Not(HasSubstr("precious")));
  const RunOutcome again = play("wait 3\n", "v.kerf.session");
  EXPECT_EQ(again.err, "") << "nothing more is left out";
}

TEST_F(SessionProgram, TheSessionOfAnotherRecordingIsKept) {
  ASSERT_EQ(play(kPrecious).exit, 0);
  std::filesystem::rename(path("v.kerf.session"), path("T.json"));
  const std::string noted = read_text(path("T.json"));
  record("buckets", 40);
  EXPECT_EQ(play("wait 3\n", "T.json").err, kept_as(path("T.json.earlier")));
  EXPECT_EQ(read_text(path("T.json.earlier")), noted);
}

TEST_F(SessionProgram, SavingReplacesNoNotesThatHaveNotComeIntoView) {
  ASSERT_EQ(play(kPrecious).exit, 0);
  const std::string noted = read_text(path("v.kerf.session"));
  const RunOutcome outcome = play("key .\nsave session\n");
  EXPECT_EQ(outcome.exit, 0);
  EXPECT_EQ(outcome.err, kept_as(path("v.kerf.session.earlier")));
  EXPECT_EQ(read_text(path("v.kerf.session.earlier")), noted);
  ASSERT_EQ(play("key Home\nkey b\nsave session\n").err, "") << "nothing was in the one that is replaced";
  EXPECT_EQ(play("save session\n").err, kept_as(path("v.kerf.session.earlier-2")));
  EXPECT_EQ(read_text(path("v.kerf.session.earlier")), noted);
}

TEST_F(SessionProgram, WhatTheUserTakesAwayIsTakenAway) {
  ASSERT_EQ(play(kPrecious).exit, 0);
  EXPECT_EQ(play("load session\nkey b\nexpect bookmarks == 0\nsave session\n").err, "");
  EXPECT_EQ(play("key b\nsave session\nkey b\nsave session\n").err, "");
  ASSERT_EQ(play(kPrecious).exit, 0);
  EXPECT_EQ(play("key b\nexpect bookmarks == 0\n", "v.kerf.session").err, "");
  EXPECT_FALSE(std::filesystem::exists(path("v.kerf.session.earlier")));
}

TEST_F(SessionProgram, LoadingAnotherSessionKeepsTheOneThatItReplaces) {
  ASSERT_EQ(play(kPrecious).exit, 0);
  const std::string noted = read_text(path("v.kerf.session"));
  ASSERT_EQ(play("key Home\nkey b\nsave session " + path("other") + "\n").exit, 0);
  EXPECT_EQ(play("load session " + path("other") + "\n", "v.kerf.session").err,
            kept_as(path("v.kerf.session.earlier")));
  EXPECT_EQ(read_text(path("v.kerf.session.earlier")), noted);
}

}  // namespace
}  // namespace kerf::test
