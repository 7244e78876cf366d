#include <gmock/gmock.h>

#include <csignal>
#include <filesystem>
#include <fstream>

#include "tests/frames/program.h"
#include "tests/viz/debugger/x_display.h"
#include "viz/image/png.h"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;

/// A recording, a script and a folder for pictures.
class DebugProgram : public ::testing::Test {
 protected:
  [[nodiscard]] std::string path(const std::string& name) const { return folder_.path() / name; }
  void write(const std::string& name, const std::string& text) const { std::ofstream(path(name)) << text; }
  void record() const {
    const RunOutcome outcome = run_kerf({"record", "pyramid", "-o", path("run.kerf"), "--steps", "40",
                                         "--config", "min_threshold=4,max_threshold=8,schedule_interval=2"});
    ASSERT_EQ(outcome.exit, 0) << outcome.err;
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(DebugProgram, RecordsASceneAndPlaysAScript) {
  write("s", "\xEF\xBB\xBFkey End\nexpect steps == 20\nexpect step == 20\nscreenshot end\n");
  const RunOutcome outcome = run_kerf({"debug", "pile", "--steps", "20", "--headless", "--script", path("s"),
                                       "-o", path("out"), "--size", "1000x640"});
  ASSERT_EQ(outcome.exit, 0) << outcome.err;
  const Image image = read_png(path("out/end.png"));
  EXPECT_EQ(image.width, 1000);
  EXPECT_EQ(image.height, 640);
}

TEST_F(DebugProgram, AScaleMakesThePictureFiner) {
  record();
  write("s", "expect scale == 2\nexpect theme == dark\nscreenshot fine\n");
  const RunOutcome outcome =
      run_kerf({"debug", path("run.kerf"), "--headless", "--script", path("s"), "-o", path("out"), "--size",
                "2000x1280", "--scale", "2", "--theme", "dark"});
  ASSERT_EQ(outcome.exit, 0) << outcome.err;
  EXPECT_EQ(read_png(path("out/fine.png")).width, 2000);
  const auto refused = [&](const std::string& option, const std::string& text) {
    return run_kerf({"debug", path("run.kerf"), "--headless", "--script", path("s"), option, text}).err;
  };
  for (const char* const scale : {"0", "nan", "9", "x"})
    EXPECT_THAT(refused("--scale", scale), HasSubstr("from 0.5 to 8")) << scale;
  EXPECT_THAT(refused("--theme", "pink"), HasSubstr("light or dark"));
}

TEST_F(DebugProgram, RemembersTheWindowInTheFileThatIsNamed) {
  record();
  const std::string file = path("config/kerf/window");
  write("change", "click \"menu tree\"\nclick \"menu right\"\nkey ctrl+-\nwait 1\n");
  write("see", "expect window ~ \"cell right 0.32 0 Tree\"\nexpect zoom == 0.9\n");
  write("default", "expect zoom == 1\nexpect message !~ layout\n");
  const auto debug = [&](const std::string& script, const std::string& window) {
    return run_kerf(
        {"debug", path("run.kerf"), "--headless", "--script", path(script), "--window-file", window});
  };
  EXPECT_EQ(debug("change", file).err, "");
  EXPECT_EQ(debug("see", file).err, "");
  EXPECT_EQ(debug("default", "none").err, "");
  write("dark", "expect theme == dark\n");
  EXPECT_EQ(run_kerf({"debug", path("run.kerf"), "--headless", "--script", path("dark"), "--window-file",
                      file, "--theme", "dark"})
                .err,
            "");
  EXPECT_EQ(debug("dark", file).err, "") << "the theme is remembered, too";
  EXPECT_EQ(run_kerf({"debug", path("run.kerf"), "--headless", "--script", path("default")}).err, "");
}

TEST_F(DebugProgram, ADamagedFileOfTheWindowIsSaidAndKeptUntilThereIsAnother) {
  record();
  const auto text_of = [&] {
    std::ifstream stream(path("window"));
    return std::string(std::istreambuf_iterator<char>(stream), {});
  };
  const std::string damaged = "# How the window of `kerf debug` looks.\ntheme dark\n";
  write("window", damaged);
  write("look",
        "expect message ~ \"default layout\"\nexpect message ~ \"its end is missing\"\nexpect theme == "
        "light\n");
  write("change", "key ctrl+=\nwait 1\n");
  const auto debug = [&](const std::string& script) {
    return run_kerf(
        {"debug", path("run.kerf"), "--headless", "--script", path(script), "--window-file", path("window")});
  };
  EXPECT_EQ(debug("look").err, "");
  EXPECT_EQ(text_of(), damaged);
  EXPECT_EQ(debug("change").err, "");
  EXPECT_THAT(text_of(), ::testing::AllOf(HasSubstr("zoom 1.1"), ::testing::EndsWith("end\n")));
}

/// Whatever file was named got the layout, the open recording, too.
TEST_F(DebugProgram, OnlyAFileOfTheWindowIsReplacedByIt) {
  record();
  write("notes.txt", "mine\n");
  write("s", "key ctrl+=\nwait 1\nscreenshot a\n");
  std::filesystem::create_hard_link(path("run.kerf"), path("link"));
  const std::string recording = test::read_text(path("run.kerf"));
  const auto debug = [&](const std::string& window, const std::string& session) {
    return run_kerf({"debug", path("run.kerf"), "--headless", "--script", path("s"), "-o", path("out"),
                     "--overwrite", "--window-file", path(window), "--session", path(session)});
  };
  const auto refusal = [&](const std::string& window) {
    const RunOutcome outcome = debug(window, "session");
    EXPECT_EQ(outcome.exit, 2) << window;
    EXPECT_FALSE(std::filesystem::exists(path("out"))) << "it ends at the start";
    return outcome.err;
  };
  EXPECT_THAT(refusal("notes.txt"), HasSubstr("notes.txt is no window file and is not replaced; choose an"));
  for (const char* const input : {"run.kerf", "link", "s", "session"})
    EXPECT_THAT(refusal(input), HasSubstr("which is read")) << input;
  EXPECT_THAT(refusal("out/a.png"), HasSubstr("would be written twice"));
  EXPECT_EQ(test::read_text(path("notes.txt")), "mine\n");
  EXPECT_EQ(test::read_text(path("run.kerf")), recording);
  write("empty", "");
  EXPECT_EQ(debug("empty", "session").exit, 0);
  EXPECT_THAT(test::read_text(path("empty")), HasSubstr("zoom 1.1"));
  EXPECT_EQ(debug("new", "notes.txt").exit, 2) << "nor is it a session";
  EXPECT_EQ(test::read_text(path("notes.txt")), "mine\n");
}

TEST_F(DebugProgram, AFailedExpectationIsAnExitCodeAndALine) {
  record();
  write("s", "key End\nexpect step == 3\n");
  const RunOutcome outcome = run_kerf({"debug", path("run.kerf"), "--headless", "--script", path("s")});
  EXPECT_EQ(outcome.exit, 1);
  EXPECT_THAT(outcome.err, HasSubstr("line 2, 'expect step == 3': step is '40'"));
}

TEST_F(DebugProgram, SaysWhatItNeeds) {
  write("s", "click \"open\n");
  EXPECT_THAT(run_kerf({"debug", "pile", "--headless"}).err, HasSubstr("needs a --script"));
  EXPECT_THAT(run_kerf({"debug", "pile", "--headless", "--script", path("s")}).err, HasSubstr("a quote"));
  EXPECT_THAT(run_kerf({"debug", "pile", "--headless", "--script", path("none")}).err,
              HasSubstr("cannot read " + path("none") + ": No such file"));
  EXPECT_THAT(run_kerf({"debug", "pil"}).err, HasSubstr("pile"));
  EXPECT_THAT(run_kerf({"debug", "pile", "--size", "300x200"}).err, HasSubstr("at least 960x600"));
}

/// As `kerf render` has it: what lies in the folder of that name does not hide a scene.
TEST_F(DebugProgram, AFileOrFolderNamedLikeASceneDoesNotHideIt) {
  write("s", "expect steps == 2\n");
  write("pile", "no recording");
  std::filesystem::create_directory(path("pyramid"));
  for (const char* const scene : {"pile", "pyramid"}) {
    std::string line = "cd " + path("") + " && exec";
    for (const std::string& word :
         kerf_command({"debug", scene, "--steps", "2", "--headless", "--script", "s"}))
      line += " " + word;
    const RunOutcome outcome = Process({"/bin/sh", "-c", line}).wait();
    EXPECT_EQ(outcome.exit, 0) << scene << ": " << outcome.err;
  }
}

TEST_F(DebugProgram, ASessionIsReadAndKeptWhereItIsNamed) {
  record();
  const auto play = [&](const std::string& script, const std::vector<std::string>& sessions) {
    write("s", script);
    std::vector<std::string> words{"debug", path("run.kerf"), "--headless", "--script", path("s")};
    for (const std::string& session : sessions) words.insert(words.end(), {"--session", path(session)});
    return run_kerf(words);
  };
  EXPECT_EQ(play("key End\nkey b\n", {}).exit, 0);
  EXPECT_FALSE(std::filesystem::exists(path("run.kerf.session"))) << "not asked for";
  EXPECT_EQ(play("key End\nkey b\n", {"mine"}).exit, 0);
  EXPECT_EQ(play("expect step == 40\nexpect bookmarks == 1\nkey Home\nkey b\n", {"mine"}).exit, 0);
  EXPECT_EQ(play("key Home\nkey shift+.\nkey b\n", {"hers"}).exit, 0);
  EXPECT_EQ(play("expect bookmarks == 3\n", {"mine", "hers"}).exit, 0);
  EXPECT_EQ(play("load session\nexpect bookmarks == 3\n", {}).exit, 0) << "beside the recording";
  EXPECT_EQ(play("expect bookmarks == 1\n", {"hers"}).exit, 0) << "it stays as it is";
  write("letter", "dear");
  const RunOutcome refused = play("key b\n", {"letter"});
  EXPECT_EQ(refused.exit, 2);
  EXPECT_THAT(refused.err, HasSubstr(path("letter") + " stays as it is: "));
  const RunOutcome unwritable = play("key b\n", {"none/mine"});
  EXPECT_EQ(unwritable.exit, 2);
  EXPECT_THAT(unwritable.err, HasSubstr("the session is not saved"));
}

TEST_F(DebugProgram, OptionsOfASceneAreRefusedForARecording) {
  record();
  write("s", "expect steps == 40\n");
  for (const char* const option :
       {"--steps", "--objects", "--grow", "--broad-phase", "--config", "--seed", "--record"}) {
    const RunOutcome outcome =
        run_kerf({"debug", path("run.kerf"), "--headless", "--script", path("s"), option, "30"});
    EXPECT_EQ(outcome.exit, 2) << option;
    EXPECT_THAT(outcome.err, HasSubstr(std::string(option) + ": "));
    EXPECT_THAT(outcome.err, HasSubstr("is a recording"));
  }
}

/// Whether a file in `folder` or below it has more than 200,000 bytes: some steps of a recording.
bool has_much(const std::filesystem::path& folder) {
  std::error_code none;
  for (std::filesystem::recursive_directory_iterator at(folder, none), end; at != end; at.increment(none))
    if (at->is_regular_file(none) && at->file_size(none) > 200'000 && !none) return true;
  return false;
}

TEST_F(DebugProgram, AMissingPlaceForTemporaryFilesIsNamed) {
  write("s", "expect steps == 2\n");
  std::vector<std::string> command =
      kerf_command({"debug", "pile", "--steps", "2", "--objects", "5", "--headless", "--script", path("s")});
  command.insert(command.begin(), {"env", "TMPDIR=/nowhere"});
  const RunOutcome outcome = Process(command).wait();
  EXPECT_EQ(outcome.exit, 2);
  EXPECT_THAT(outcome.err, HasSubstr("TMPDIR, which is '/nowhere'"));
}

/// What was recorded until then goes away with the temporary folder, unless it has a name.
TEST_F(DebugProgram, InterruptedWhileItRecordsItNamesOnlyWhatIsKept) {
  for (const bool kept : {false, true}) {
    write("s", "expect steps == 0\n");
    const TemporaryFolder temporary;
    std::vector<std::string> command = kerf_command(
        {"debug", "pile", "--steps", "900000", "--objects", "30", "--headless", "--script", path("s")});
    if (kept) command.insert(command.end(), {"--record", path("kept.kerf")});
    command.insert(command.begin(), {"env", "TMPDIR=" + temporary.path().string()});
    Process process(command);
    ASSERT_TRUE(holds_within_a_minute(
        [&] { return has_much(kept ? std::filesystem::path(path("")) : temporary.path()); }));
    process.signal(SIGINT);
    const RunOutcome outcome = process.wait();
    EXPECT_EQ(outcome.exit, 130);
    EXPECT_THAT(outcome.err, HasSubstr("interrupted"));
    EXPECT_EQ(outcome.err.find(" in " + path("kept.kerf")) != std::string::npos, kept);
    EXPECT_EQ(outcome.err.find("run.kerf"), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.err.find("keep it by --record") != std::string::npos, !kept) << outcome.err;
    EXPECT_EQ(std::filesystem::exists(path("kept.kerf")), kept);
    EXPECT_TRUE(temporary.files().empty());
  }
}

/// The window is there at once, with a bar; Enter has enough of the steps so far, Escape ends all of it.
TEST_F(DebugProgram, TheWindowShowsARecordingThatCanBeEnded) {
  write("s", "expect steps > 0\nexpect steps < 900000\n");
  for (const bool is_enough : {true, false}) {
    test::XDisplay display;
    Process process(
        kerf_command({"debug", "pile", "--steps", "900000", "--objects", "30", "--script", path("s")}));
    display.wait_for_window();
    display.tap(is_enough ? "Return" : "Escape");
    display.flush();
    const RunOutcome outcome = process.wait();
    EXPECT_EQ(outcome.exit, is_enough ? 0 : 130) << outcome.err;
    EXPECT_EQ(outcome.err.find("keep it by --record") == std::string::npos, is_enough) << outcome.err;
  }
}

TEST_F(DebugProgram, AFileThatIsNotThereIsNoScene) {
  for (const char* const command : {"debug", "render"}) {
    for (const std::string& name : {std::string("nope.kerf"), path("nope")}) {
      const RunOutcome outcome = run_kerf({command, name});
      EXPECT_NE(outcome.exit, 0);
      EXPECT_THAT(outcome.err, HasSubstr("there is no recording " + name)) << command;
      EXPECT_THAT(outcome.err, ::testing::Not(HasSubstr("scene '"))) << command;
    }
  }
}

TEST_F(DebugProgram, AFolderThatCannotBeIsNamedBeforeTheWork) {
  write("s", "screenshot a\n");
  const RunOutcome outcome =
      run_kerf({"debug", "pile", "--steps", "5", "--headless", "--script", path("s"), "-o", "/proc/no"});
  EXPECT_EQ(outcome.exit, 2);
  EXPECT_THAT(outcome.err, HasSubstr("cannot make the folder /proc/no: "));
  EXPECT_THAT(outcome.err, HasSubstr("--out"));
  EXPECT_EQ(outcome.out, "");
}

TEST_F(DebugProgram, PicturesStayInTheirFolder) {
  record();
  for (const std::string name : {"../a", "/a", "b/a", "\"\""}) {
    write("s", "screenshot " + name + "\n");
    const RunOutcome outcome =
        run_kerf({"debug", path("run.kerf"), "--headless", "--script", path("s"), "-o", path("shots")});
    EXPECT_EQ(outcome.exit, 2);
    EXPECT_THAT(outcome.err, HasSubstr("is no name of a picture"));
  }
  EXPECT_FALSE(std::filesystem::exists(path("a.png")));
}

TEST_F(DebugProgram, WithoutADisplayItSaysWhatToDo) {
  record();
  const std::string command = "unset DISPLAY WAYLAND_DISPLAY; exec \"$0\" debug \"$1\"";
  const RunOutcome outcome =
      Process({"/bin/sh", "-c", command, test::kerf_command({})[0], path("run.kerf")}).wait();
  EXPECT_EQ(outcome.exit, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--headless"));
}

/// What is wrong with a file that was not named is said in the window, which opens all the same.
TEST_F(DebugProgram, AForeignFileInThePlaceOfTheWindowsIsNoReasonNotToStart) {
  record();
  std::filesystem::create_directories(path("config/kerf"));
  write("config/kerf/debug-window", "mine\n");
  const std::string command =
      "unset DISPLAY WAYLAND_DISPLAY; export XDG_CONFIG_HOME=\"$2\"; exec \"$0\" debug \"$1\"";
  const RunOutcome outcome =
      Process({"/bin/sh", "-c", command, test::kerf_command({})[0], path("run.kerf"), path("config")}).wait();
  EXPECT_THAT(outcome.err, HasSubstr("--headless")) << "only the display was missing";
  EXPECT_EQ(test::read_text(path("config/kerf/debug-window")), "mine\n");
}

/// Pixels of two pictures that differ by more than `tolerance` in a channel.
std::size_t different_pixels(const Image& a, const Image& b, int tolerance) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < a.rgba.size(); k += 4) {
    bool differs = false;
    for (std::size_t c = 0; c < 4; ++c) differs |= std::abs(a.rgba[k + c] - b.rgba[k + c]) > tolerance;
    count += differs ? 1 : 0;
  }
  return count;
}

TEST_F(DebugProgram, AWindowShowsWhatIsDrawnWithoutOne) {
  record();
  write(
      "s",
      "key End\nkey ,\ndouble view@0.5,0.5\ndrag view@0.3,0.3 view@0.45,0.4\nwheel 2\nclick \"tab Oracle\"\n"
      "screenshot a\nkey ,\nkey ,\nclick n0\nhover 5,5\nscreenshot b\n");
  const RunOutcome without =
      run_kerf({"debug", path("run.kerf"), "--headless", "--script", path("s"), "-o", path("without")});
  ASSERT_EQ(without.exit, 0) << without.err;
  std::vector<std::string> command{"/usr/bin/xvfb-run", "-a", "-s", "-screen 0 1400x900x24"};
  for (const std::string& word :
       test::kerf_command({"debug", path("run.kerf"), "--script", path("s"), "-o", path("with")}))
    command.push_back(word);
  const RunOutcome with = Process(command).wait();
  ASSERT_EQ(with.exit, 0) << with.err;
  for (const std::string name : {"a", "b"}) {
    const Image expected = read_png(path("without/" + name + ".png"));
    const Image shown = read_png(path("with/" + name + ".png"));
    ASSERT_EQ(expected.width, shown.width);
    EXPECT_EQ(different_pixels(expected, shown, 0), 0U) << name;
  }
  EXPECT_GT(different_pixels(read_png(path("with/a.png")), read_png(path("with/b.png")), 0), 1000U);
}

/// Three boxes in a row, of which neighbours overlap: in step 2 one pair is missed, in step 3 one is
/// invented, in step 4 one is reported twice.
TEST_F(DebugProgram, AnImportStopsWhereTheirPairsAreWrong) {
  std::string boxes = "step,object,min_x,max_x,min_y,max_y\n";
  for (const std::string step : {"1", "2", "3", "4", "5"})
    boxes += step + ",0,0,1,0,1\n" + step + ",1,0.5,1.5,0,1\n" + step + ",2,1.2,2.2,0,1\n";
  write("boxes.csv", boxes);
  write("pairs.csv",
        "step,a,b\n1,0,1\n1,1,2\n2,0,1\n3,0,1\n3,1,2\n3,0,2\n4,0,1\n4,2,1\n4,1,2\n5,0,1\n5,1,2\n");
  const RunOutcome imported =
      run_kerf({"import", path("boxes.csv"), "--pairs", path("pairs.csv"), "-o", path("run.kerf")});
  ASSERT_EQ(imported.exit, 0) << imported.err;
  write("s",
        "click condition\ntype missed>0\nkey Enter\nclick condition\ntype extra>0\nkey Enter\n"
        "click condition\ntype twice>0\nkey Enter\nkey Escape\n"
        "key F5\nexpect step == 2\nexpect hits0 == 1\nkey F5\nexpect step == 3\nexpect hits1 == 1\n"
        "key F5\nexpect step == 4\nexpect hits2 == 1\nkey F5\nexpect message ~ \"no breakpoint\"\n"
        "key End\nkey shift+F5\nexpect step == 4\nkey shift+F5\nexpect step == 3\n"
        "key shift+F5\nexpect step == 2\nexpect hits0 == 2\n"
        "click \"tab Oracle\"\nwait 2\nclick \"missed 0\"\nexpect selection == \"pair 1,2\"\n"
        "key F5\nwait 2\nclick \"pair 0,2\"\nexpect selection == \"pair 0,2\"\n"
        "key F5\nwait 2\nclick \"twice 0\"\nexpect selection == \"pair 1,2\"\n");
  const RunOutcome debugged = run_kerf({"debug", path("run.kerf"), "--headless", "--script", path("s")});
  EXPECT_EQ(debugged.exit, 0) << debugged.err;
}

TEST_F(DebugProgram, LintFindsWhatWaits) {
  const RunOutcome recorded =
      run_kerf({"record", "pile", "-o", path("run.kerf"), "--steps", "100", "--objects", "200", "--grow",
                "60", "--config", "min_threshold=8,max_threshold=16"});
  ASSERT_EQ(recorded.exit, 0) << recorded.err;
  const RunOutcome found = run_kerf({"lint", path("run.kerf"), "--within", "1"});
  EXPECT_EQ(found.exit, 1);
  EXPECT_THAT(found.out, ::testing::ContainsRegex("e[0-9]+  "));
  const RunOutcome none = run_kerf({"lint", path("run.kerf"), "--within", "1000"});
  EXPECT_EQ(none.exit, 0) << none.out;
  EXPECT_EQ(run_kerf({"lint", path("run.kerf"), "--within", "0"}).exit, 2);
}

}  // namespace
}  // namespace kerf::test
