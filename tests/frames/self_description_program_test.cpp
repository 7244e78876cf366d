// What the program prints about itself for `man` and for shells: all of them have each command.
#include <gmock/gmock.h>

#include <fstream>
#include <string>

#include "frames/commands/exit_codes.h"
#include "tests/frames/program.h"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;

TEST(SelfDescriptionProgram, EveryCommandIsInThePageAndInEachCompletion) {
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {"man"}, {"completion", "bash"}, {"completion", "zsh"}, {"completion", "fish"}}) {
    const RunOutcome outcome = run_kerf(arguments);
    for (const ExitMeaning& meaning : exit_meanings()) {
      std::string name(meaning.command);
      if (arguments.front() == "man")
        for (std::size_t at = name.find('-'); at != std::string::npos; at = name.find('-', at + 2))
          name.insert(at, "\\");
      EXPECT_THAT(outcome.out, HasSubstr(name)) << arguments.back();
    }
  }
}

TEST(SelfDescriptionProgram, OptionsOfGroupsAreShown) {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"completion", "zsh"}, {"completion", "fish"}})
    EXPECT_THAT(run_kerf(arguments).out, HasSubstr("chrome-trace")) << arguments.back();
  EXPECT_THAT(run_kerf({"man"}).out, HasSubstr("chrome\\-trace"));
}

TEST(SelfDescriptionProgram, ThePageSaysWhereTheOtherPagesAre) {
  const std::string page = run_kerf({"man"}).out;
  EXPECT_THAT(page, HasSubstr("docs/DEBUGGING.md is a guide"));
  EXPECT_THAT(page, HasSubstr(".SH SEE ALSO\n"));
  EXPECT_THAT(page, HasSubstr("/usr/share/doc/kerf\\-doc"));
}

TEST(SelfDescriptionProgram, BashCompletesCommandsAndOptions) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "script") << run_kerf({"completion", "bash"}).out;
  const auto completed = [&](const std::string& words, const std::string& at) {
    return Process({"bash", "-c",
                    "source '" + (folder.path() / "script").string() + "'; COMP_WORDS=(" + words +
                        "); COMP_CWORD=" + at + "; _kerf; echo \"${COMPREPLY[@]}\""})
        .wait()
        .out;
  };
  EXPECT_EQ(completed("kerf rende", "1"), "render\n");
  EXPECT_EQ(completed("kerf render --conta", "2"), "--contact-sheet\n");
  EXPECT_EQ(completed("kerf explain --pa", "2"), "--pair\n");  // of an option group
  EXPECT_EQ(completed("kerf --vers", "1"), "--version\n");
  EXPECT_EQ(completed("kerf render a", "2"), "\n");  // bash then completes names of files
}

}  // namespace
}  // namespace kerf::test
