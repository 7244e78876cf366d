// `kerf doctor` says what is there, and what to do about what is not.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <utility>

#include "frames/sequence/video.h"
#include "frames/support/errors.h"
#include "tests/frames/program.h"

namespace kerf::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

const nlohmann::json& part(const nlohmann::json& report, const std::string& name) {
  for (const auto& each : report.at("parts"))
    if (each.at("name") == name) return each;
  throw std::runtime_error("no part " + name);
}

TEST(DoctorProgram, SaysWhatIsThere) {
  const RunOutcome outcome = run_kerf({"doctor"});
  EXPECT_EQ(outcome.exit, kExitHolds) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("ok      drawing"));
  EXPECT_THAT(outcome.out, HasSubstr("ok      films"));
}

TEST(DoctorProgram, SaysWhatToDoAboutWhatIsMissing) {
  const RunOutcome outcome = run_kerf({"doctor", "--json"}, {.path = "/nowhere"});
  EXPECT_EQ(outcome.exit, kExitHolds) << "no picture needs them";
  const auto report = nlohmann::json::parse(outcome.out);
  for (const char* name : {"films", "plots", "Python module"}) {
    EXPECT_EQ(part(report, name).at("there"), false) << name;
    EXPECT_THAT(part(report, name).at("advice").get<std::string>(), HasSubstr("Debian: ")) << name;
  }
  EXPECT_EQ(part(report, "threads").at("there"), true);
}

TEST(DoctorProgram, SaysWhichPythonModuleIsFound) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "kerf");
  std::ofstream(folder.path() / "kerf" / "__init__.py") << "__version__ = '9.8.7'\n";
  const std::string command = "PYTHONPATH='" + folder.path().string() + "' exec \"$0\" doctor";
  const RunOutcome outcome = Process({"sh", "-c", command, KERF_PROGRAM}).wait();
  EXPECT_EQ(outcome.exit, kExitHolds);
  EXPECT_THAT(outcome.out, HasSubstr("ok      Python module   kerf 9.8.7 for Python 3."));
}

/// Runs `kerf doctor --json` where `import kerf` runs this text, or finds an empty folder.
nlohmann::json report_with_module(const char* text) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "kerf");
  if (text != nullptr) std::ofstream(folder.path() / "kerf" / "__init__.py") << text;
  const std::string command = "PYTHONPATH='" + folder.path().string() + "' exec \"$0\" doctor --json";
  const RunOutcome outcome = Process({"sh", "-c", command, KERF_PROGRAM}).wait();
  EXPECT_EQ(outcome.exit, kExitHolds) << outcome.err;
  return part(nlohmann::json::parse(outcome.out), "Python module");
}

/// They were all "python3 does not find the module kerf", with the advice to install it.
TEST(DoctorProgram, SaysWhyAPythonModuleCannotBeImported) {
  for (const auto& [text, problem] :
       {std::pair("import nowhere_at_all\n",
                  "/python3 cannot import the module kerf: ModuleNotFoundError: No module "
                  "named 'nowhere_at_all'"),
        std::pair("raise ImportError('another\\nPython')\n", "kerf: ImportError: another Python"),
        std::pair("print('hello')\n", "kerf: AttributeError: module 'kerf' has no attribute '__version__'"),
        std::pair("raise SystemExit(3)\n", "kerf: SystemExit: 3"),
        std::pair("import os\nos.kill(os.getpid(), 9)\n", "kerf: it ends without an answer")}) {
    const auto module = report_with_module(text);
    EXPECT_EQ(module.at("there"), false);
    EXPECT_THAT(module.at("what").get<std::string>(), HasSubstr(problem));
    EXPECT_THAT(module.at("advice").get<std::string>(), Not(HasSubstr("install it")));
  }
}

TEST(DoctorProgram, AFolderOfItsNameIsNoPythonModule) {
  if (part(nlohmann::json::parse(run_kerf({"doctor", "--json"}).out), "Python module").at("there"))
    GTEST_SKIP() << "python3 finds one";
  const auto module = report_with_module(nullptr);
  EXPECT_THAT(module.at("what").get<std::string>(), HasSubstr("/python3 does not find the module kerf"));
  EXPECT_THAT(module.at("advice").get<std::string>(), HasSubstr("install it (Debian: python3-kerf)"));
}

TEST(DoctorProgram, WithoutADisplayItSaysHowToDoWithout) {
  const std::string command = "unset DISPLAY WAYLAND_DISPLAY; exec \"$0\" doctor";
  const RunOutcome outcome = Process({"sh", "-c", command, KERF_PROGRAM}).wait();
  EXPECT_EQ(outcome.exit, kExitHolds);
  EXPECT_THAT(outcome.out, HasSubstr("missing display"));
  EXPECT_THAT(outcome.out, HasSubstr("xvfb-run"));
}

/// libegl-mesa0 alone has no libEGL.so.1. Nothing draws where both libraries are unreadable.
TEST(DoctorProgram, NamesEveryPackageThatDrawingNeeds) {
  const test::TemporaryFolder folder;
  for (const char* library : {"libEGL.so.1", "libOSMesa.so.8"}) std::ofstream(folder.path() / library) << "";
  const RunOutcome outcome = run_kerf({"doctor", "--json"}, {.libraries = folder.path().string()});
  EXPECT_EQ(outcome.exit, kExitDoesNotHold);
  const auto report = nlohmann::json::parse(outcome.out);
  for (const char* name : {"drawing", "drawing by EGL"})
    EXPECT_THAT(part(report, name).at("advice").get<std::string>(), HasSubstr("libegl1 libegl-mesa0"))
        << name;
}

TEST(DoctorProgram, WhatPicturesNeedIsAFailure) {
  const std::string command = "TMPDIR=/nowhere exec \"$0\" doctor";
  const RunOutcome outcome = Process({"sh", "-c", command, KERF_PROGRAM}).wait();
  EXPECT_EQ(outcome.exit, kExitDoesNotHold);
  EXPECT_THAT(outcome.out, HasSubstr("MISSING room"));
  EXPECT_THAT(outcome.err, HasSubstr("1 part"));
}

TEST(Video, NamesFilmsThatHaveNoEncoder) {
  const std::string some =
      " V....D libx264              H.264\n V....D libx264rgb  RGB\n VF...D apng  APNG\n";
  EXPECT_THAT(Video::extensions_without_encoder(some), ElementsAre(".webm", ".gif"));
  EXPECT_THAT(Video::extensions_without_encoder(some + " V....D gif  G\n V....D libvpx-vp9 VP9\n"),
              IsEmpty());
}

}  // namespace
}  // namespace kerf::test
