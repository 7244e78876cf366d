#include "tests/outputs/output_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <memory>
#include <regex>
#include <sstream>

#include "core/files/part_file.h"
#include "core/recording/recording_reader.h"
#include "frames/support/errors.h"
#include "tests/frames/program.h"

namespace kerf::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAreArray;
using Words = std::vector<std::string>;
using Files = std::map<std::string, std::string>;

constexpr int kRefused = 2;

void run(const Words& arguments) {
  const RunOutcome outcome = run_kerf(arguments);
  ASSERT_EQ(outcome.exit, 0) << arguments.front() << ": " << outcome.err;
}

Files files_below(const fs::path& folder) {
  Files files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      files[entry.path().lexically_relative(folder).string()] = read_text(entry.path());
  return files;
}

Words parts_below(const fs::path& folder) {
  Words parts;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (is_part_name(entry.path().filename().string())) parts.push_back(entry.path().filename().string());
  return parts;
}

/// One of each kind of input, made once.
class Inputs {
 public:
  Inputs() {
    const fs::path folder = folder_.path();
    run({"record", "pile", "-o", folder / "in.kerf", "--steps", "12", "--objects", "20"});
    run({"record", "pile", "-o", folder / "earlier.kerf", "--steps", "4", "--objects", "20"});
    for (const char* const out : {"frames", "other"})
      run({"render", folder / "in.kerf", "--steps", "1:2:1", "--size", "64x64", "--workers", "0", "--out",
           folder / out});
    run({"export", folder / "in.kerf", "--boxes", "-o", folder / "boxes.csv"});
    std::ofstream(folder / "script") << "screenshot shot\n";
    fs::copy_file(folder / "frames/in_000000.png", folder / "picture.png");
    std::ofstream(folder / "study.json") << R"({"matrices": [{"motions": "uniform", "dimensions": 2,
"objects": 40, "broad_phases": "kerf", "warm_up": 1, "steps": 2}]})";
    fs::create_directory(folder / "hard");
    std::ofstream(folder / "hard/hardcases.json")
        << R"({"columns":[{"dimension":2,"who":"kerf","name":"box"}],
"cases":[{"id":"V1","name":"NotANumber","what":"","cells":[{"verdict":"exact","sign":"="}]}]})";
  }
  [[nodiscard]] const fs::path& path() const { return folder_.path(); }

 private:
  TemporaryFolder folder_;
};

const std::map<std::string, std::string>& input_names() {
  static const std::map<std::string, std::string> kNames{
      {"RECORDING", "in.kerf"}, {"FRAMES", "frames"},       {"OTHER", "other"}, {"BOXES", "boxes.csv"},
      {"SCRIPT", "script"},     {"PICTURE", "picture.png"}, {"HARD", "hard"},   {"STUDY", "study.json"}};
  return kNames;
}

class OutputTable : public ::testing::TestWithParam<OutputCase> {
 protected:
  static void SetUpTestSuite() { inputs_ = std::make_unique<Inputs>(); }
  static void TearDownTestSuite() { inputs_.reset(); }

  void SetUp() override { fs::copy(inputs_->path(), work(), fs::copy_options::recursive); }

  [[nodiscard]] static const OutputCase& row() { return GetParam(); }
  [[nodiscard]] fs::path work() const { return folder_.path() / "work"; }
  [[nodiscard]] bool is_folder() const {
    return row().kind != OutputKind::file && row().kind != OutputKind::recording;
  }
  /// The file that is replaced, and what the option is given.
  [[nodiscard]] fs::path target() const { return work() / row().name; }
  [[nodiscard]] fs::path given() const {
    return row().kind == OutputKind::folder ? target().parent_path() : target();
  }

  [[nodiscard]] RunOutcome run_to(const fs::path& out, bool overwrite,
                                  const Surroundings& surroundings = {}) const {
    Words words{row().command};
    for (const std::string& word : row().arguments) words.push_back(in_place(word, out));
    if (overwrite && row().kind != OutputKind::temporary) words.emplace_back("--overwrite");
    return run_kerf(words, surroundings);
  }

  /// What has the name already, of a kind that may be replaced.
  void make_earlier() const {
    if (row().kind == OutputKind::temporary) return;
    fs::create_directories(target().parent_path());
    if (row().kind == OutputKind::sequence) {
      fs::remove_all(target());
      run({"render", work() / "earlier.kerf", "--steps", "1:4:1", "--size", "80x64", "--workers", "0",
           "--out", target()});
    } else if (row().kind == OutputKind::recording) {
      fs::copy_file(work() / "earlier.kerf", target());
    } else {
      std::ofstream(target()) << "earlier";
    }
  }

  /// The run is refused as wrong usage and changes nothing. Returns why.
  std::string refusal(const fs::path& out, bool overwrite) const {
    const Files before = files_below(work());
    const RunOutcome outcome = run_to(out, overwrite);
    EXPECT_EQ(outcome.exit, kRefused) << out << ": " << outcome.err;
    EXPECT_TRUE(files_below(work()) == before) << out << " has changed something";
    return outcome.err;
  }

 private:
  [[nodiscard]] std::string in_place(const std::string& word, const fs::path& out) const {
    if (word == "OUT") return out;
    if (word.starts_with("SCRATCH")) return work() / ("scratch" + word.substr(7));
    const auto input = input_names().find(word);
    return input == input_names().end() ? word : (work() / input->second).string();
  }

  static inline std::unique_ptr<Inputs> inputs_;
  TemporaryFolder folder_;
};

/// By its name, by a link, and by a way around; a hard link is the same file, too.
TEST_P(OutputTable, InputsAreRefused) {
  int tried = 0;
  for (const std::string& word : row().arguments) {
    const auto input = input_names().find(word);
    if (input == input_names().end()) continue;
    const fs::path file = work() / input->second;
    if (!is_folder() && fs::is_directory(file)) {
      std::ofstream(file / target().filename()) << "within";
      EXPECT_THAT(refusal(file / target().filename(), true), HasSubstr("which is read"));
      ++tried;
    }
    if (is_folder() != fs::is_directory(file) || row().kind == OutputKind::folder) continue;
    ++tried;
    const fs::path link = work() / ("link-" + target().filename().string());
    fs::create_symlink(file, link);
    EXPECT_THAT(refusal(link, true), HasSubstr("which is read")) << word;
    refusal(file, true);
    refusal(work() / "hard/.." / input->second, true);
    fs::remove(link);
    if (is_folder()) continue;
    fs::create_hard_link(file, link);
    EXPECT_THAT(refusal(link, true), HasSubstr("which is read")) << word;
    fs::remove(link);
  }
  if (tried == 0) GTEST_SKIP() << "no input of that kind";
}

TEST_P(OutputTable, ARecordingIsReplacedByARecordingOnly) {
  if (row().kind == OutputKind::recording) {
    std::ofstream(target()) << "no recording";
    EXPECT_THAT(refusal(target(), true), HasSubstr("is no recording"));
    return;
  }
  const fs::path place = is_folder() ? given() : target();
  if (row().kind == OutputKind::folder) {
    fs::create_directories(given());
    fs::copy_file(work() / "earlier.kerf", target());
    EXPECT_THAT(refusal(given(), true), HasSubstr("is a recording"));
    fs::remove_all(given());
  }
  if (fs::is_directory(place)) fs::remove_all(place);
  fs::copy_file(work() / "earlier.kerf", place);
  EXPECT_THAT(refusal(place, true), HasSubstr(is_folder() ? "not a folder" : "is a recording"));
}

TEST_P(OutputTable, FoldersAndLinksToNothingAreRefused) {
  if (row().kind == OutputKind::sequence || row().kind == OutputKind::temporary)
    GTEST_SKIP() << "it is a folder";
  fs::create_directories(target());
  EXPECT_THAT(refusal(given(), true), HasSubstr("is a folder"));
  fs::remove(target());
  fs::create_symlink("nothing", target());
  EXPECT_THAT(refusal(given(), true), HasSubstr("link to nothing"));
}

TEST_P(OutputTable, WhatIsThereIsKeptUnlessAskedOtherwise) {
  if (row().kind == OutputKind::temporary) GTEST_SKIP() << "nothing stays there";
  make_earlier();
  EXPECT_THAT(refusal(given(), false), HasSubstr("--overwrite"));
}

/// No file may become longer than a few bytes.
TEST_P(OutputTable, ARunThatFailsKeepsWhatWasThereAndLeavesNoPart) {
  make_earlier();
  const Files before = files_below(work());
  constexpr std::uint64_t kFewBytes = 60;
  const RunOutcome outcome = run_to(given(), true, {kFewBytes, ""});
  EXPECT_NE(outcome.exit, kExitHolds);
  EXPECT_LT(outcome.exit, 126) << "it ends by itself";
  const Files after = files_below(work());
  for (const auto& [name, contents] : before)
    EXPECT_TRUE(after.contains(name) && after.at(name) == contents) << name;
  EXPECT_THAT(parts_below(work()), IsEmpty());
}

TEST_P(OutputTable, ItIsReplacedWhenAskedAndOnlyThen) {
  if (!row().succeeds) GTEST_SKIP() << "takes too long";
  make_earlier();
  const fs::path file = row().kind == OutputKind::sequence ? target() / "frames.json" : target();
  const std::string before = read_text(file);
  const RunOutcome outcome = run_to(given(), true);
  ASSERT_EQ(outcome.exit, kExitHolds) << outcome.err;
  EXPECT_FALSE(read_text(file) == before);
  EXPECT_THAT(parts_below(work()), IsEmpty());
  if (row().kind == OutputKind::recording) {
    EXPECT_TRUE(read_recording_info(file).complete);
  }
}

/// A link to a file stays one, and the file that it leads to is replaced.
TEST_P(OutputTable, ALinkIsFollowed) {
  if (is_folder() || !row().succeeds) GTEST_SKIP() << "not of this kind";
  make_earlier();
  const fs::path real = work() / ("real-" + target().filename().string());
  fs::rename(target(), real);
  fs::create_symlink(real.filename(), target());
  const std::string before = read_text(real);
  const RunOutcome outcome = run_to(given(), true);
  ASSERT_EQ(outcome.exit, kExitHolds) << outcome.err;
  EXPECT_TRUE(fs::is_symlink(target()));
  EXPECT_FALSE(read_text(real) == before);
}

std::string name_of(const ::testing::TestParamInfo<OutputCase>& info) {
  std::string name = info.param.command + "_" + info.param.option;
  std::erase_if(name, [](char c) { return c == '-' || c == ','; });
  return name;
}

INSTANTIATE_TEST_SUITE_P(Options, OutputTable, ::testing::ValuesIn(output_table()), name_of);

/// "  -o,--out FILE REQUIRED   meaning" of a part of a help, as "COMMAND -o,--out".
struct HelpOption {
  std::string name;
  std::string type;
  bool is_output = false;
};

std::vector<HelpOption> options_of(const std::string& command) {
  std::vector<HelpOption> options;
  std::istringstream help(run_kerf({command, "--help"}).out);
  bool in_outputs = false;
  static const std::regex kOption(R"(^  (-[-,\w]+)(?: ([^ ]+))?.*)");
  for (std::string line; std::getline(help, line);) {
    if (!line.empty() && line[0] != ' ') in_outputs = line == "Outputs:";
    std::smatch match;
    if (std::regex_match(line, match, kOption))
      options.push_back({command + " " + match[1].str(), match[2], in_outputs});
  }
  return options;
}

Words commands() {
  Words names;
  std::istringstream help(run_kerf({"--help"}).out);
  bool in_commands = false;
  for (std::string line, name; std::getline(help, line);) {
    if (!line.empty() && line[0] != ' ') in_commands = line == "Subcommands:";
    if (in_commands && line.starts_with("  ") && line[2] != ' ' && std::istringstream(line) >> name)
      names.push_back(name);
  }
  return names;
}

/// An option that names a file or folder is an output or an input: a new one must be in one of the tables.
TEST(OutputOptions, AreAllInTheTable) {
  Words outputs;
  Words inputs;
  ASSERT_GT(commands().size(), 15U);
  for (const std::string& command : commands())
    for (const HelpOption& option : options_of(command)) {
      const bool names_a_place =
          option.type.starts_with("FILE") || option.type == "DIR" || option.type.starts_with("FOLDER");
      if (option.is_output) outputs.push_back(option.name);
      if (!option.is_output && names_a_place) inputs.push_back(option.name);
    }
  Words table;
  for (const OutputCase& row : output_table()) table.push_back(row.command + " " + row.option);
  EXPECT_THAT(outputs, UnorderedElementsAreArray(table)) << "see add_output";
  EXPECT_THAT(inputs, UnorderedElementsAreArray(input_options())) << "an output is added by add_output";
}

}  // namespace
}  // namespace kerf::test
