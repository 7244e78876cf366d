#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "tests/frames/program.h"
#include "viz/image/png.h"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Image spotted(int x, std::uint8_t red) {
  Image image = make_image(48, 32, 0xfafaf7ffU);
  image.rgba[static_cast<std::size_t>(4 * (10 * image.width + x))] = red;
  return image;
}

/// Two folders with the same three frames.
class DiffProgram : public ::testing::Test {
 protected:
  DiffProgram() {
    for (const auto& folder : {reference(), test()}) {
      std::filesystem::create_directories(folder);
      for (int i = 0; i < 3; ++i) write_png(folder / ("f" + std::to_string(i) + ".png"), spotted(9 * i, 0));
    }
  }
  [[nodiscard]] std::filesystem::path reference() const { return folder_.path() / "reference"; }
  [[nodiscard]] std::filesystem::path test() const { return folder_.path() / "test"; }
  [[nodiscard]] std::filesystem::path in_test(int i) const {
    return test() / ("f" + std::to_string(i) + ".png");
  }
  [[nodiscard]] RunOutcome diff(std::vector<std::string> options = {}) const {
    std::vector<std::string> arguments{"diff", reference(), test()};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_kerf(arguments);
  }
  void manifest(const std::string& text) const { std::ofstream(test() / "frames.json") << text; }
  void manifests(const std::string& in_reference, const std::string& in_test) const {
    std::ofstream(reference() / "frames.json") << in_reference;
    manifest(in_test);
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(DiffProgram, SameFoldersEndWithZero) {
  const RunOutcome outcome = diff();
  EXPECT_EQ(outcome.exit, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("3 frames are the same"));
}

TEST_F(DiffProgram, OneStepOfOneChannelIsADifferenceAndIsShown) {
  write_png(in_test(1), spotted(9, 1));
  const RunOutcome outcome = diff();
  EXPECT_EQ(outcome.exit, 1);
  EXPECT_THAT(outcome.out,
              HasSubstr("f1.png: 1 of 1536 pixels differs, within 1x1 at (9, 10), by up to 1 of 255"));
  EXPECT_THAT(outcome.out, HasSubstr("(9, 10) #00faf7 -> #01faf7"));
  EXPECT_THAT(outcome.err, HasSubstr("1 of 3 frames differs"));
  EXPECT_EQ(diff({"--gate", "flip"}).exit, 0);
}

TEST_F(DiffProgram, TheGateFlipSeesWhatPeopleSee) {
  write_png(in_test(2), spotted(40, 0));
  EXPECT_EQ(diff({"--gate", "flip", "--flip-limit", "0.05"}).exit, 1);
  EXPECT_EQ(diff({"--gate", "flip", "--flip-limit", "1"}).exit, 0);
}

/// Over white the two look the same.
TEST_F(DiffProgram, TheGateFlipSeesWhatIsTransparent) {
  Image white = make_image(48, 32);
  std::ranges::fill(white.rgba, std::uint8_t{255});
  write_png(in_test(1), white);
  write_png(reference() / "f1.png", white);
  EXPECT_EQ(diff({"--gate", "flip"}).exit, 0);
  for (std::size_t k = 3; k < white.rgba.size(); k += 4) white.rgba[k] = 0;
  write_png(in_test(1), white);
  EXPECT_EQ(diff({"--gate", "flip"}).exit, 1);
  EXPECT_THAT(diff({"--gate", "flip"}).out, HasSubstr("alpha differs by up to 255 of 255"));
}

TEST_F(DiffProgram, MissingAndExtraFramesAreNamed) {
  std::filesystem::rename(in_test(2), in_test(7));
  const RunOutcome outcome = diff();
  EXPECT_EQ(outcome.exit, 1);
  EXPECT_THAT(outcome.out, HasSubstr("f2.png: it is missing"));
  EXPECT_THAT(outcome.out, HasSubstr("f7.png: it has no reference"));
  EXPECT_THAT(outcome.err, HasSubstr("2 of 4 frames differ, 1 of them missing, 1 without a reference"));
}

TEST_F(DiffProgram, JsonSaysTheSame) {
  write_png(in_test(1), spotted(9, 90));
  const RunOutcome outcome = diff({"--json"});
  EXPECT_EQ(outcome.exit, 1);
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json.at("same"), false);
  EXPECT_EQ(json.at("frames").at(0).at("verdict"), "same");
  EXPECT_EQ(json.at("frames").at(1).at("verdict"), "different");
  EXPECT_EQ(json.at("frames").at(1).at("pixels").at("largest_step"), 90);
  EXPECT_GT(json.at("frames").at(1).at("flip").at("max"), 0.0);
}

// Whatever cannot be compared must not count as the same.
TEST_F(DiffProgram, WhatCannotBeReadIsUnusable) {
  const auto expect_unusable = [this](const std::string& reason) {
    const RunOutcome outcome = diff();
    EXPECT_EQ(outcome.exit, 2) << reason;
    EXPECT_THAT(outcome.out + outcome.err, HasSubstr(reason));
    EXPECT_THAT(outcome.out + outcome.err, Not(HasSubstr("the same")));
  };
  std::filesystem::resize_file(in_test(1), std::filesystem::file_size(in_test(1)) - 15);
  expect_unusable("the file is truncated");
  write_png(in_test(1), make_image(32, 48));
  expect_unusable("they are of different sizes: 48x32 and 32x48");
  std::ofstream(in_test(1)) << "no picture";
  expect_unusable("it is not a PNG");
  write_png(in_test(1), spotted(9, 0));
  manifest(R"({"frames": [{"file": "f0.png"}, {"file": "f3.png"}]})");
  expect_unusable("'f3.png' is not in");
  manifest(R"({"frames": [{"file": "f0.png", "step": 1}, {"file": "f0.png", "step": 2}]})");
  expect_unusable("'f0.png' is named more than once by");
  for (const char* const mistyped :
       {"{", R"({"frames": [{"file": 3}]})", R"({"frames": [3]})", R"({"frames": [], "complete": 1})"}) {
    manifest(mistyped);
    expect_unusable("frames.json is no manifest of frames");
  }
  std::filesystem::remove_all(test());
  expect_unusable("there is no such file or folder");
  std::filesystem::create_directory(test());
  expect_unusable("it holds no PNG file");
}

TEST_F(DiffProgram, AnImageThatIsTooLargeIsUnusableEvenAgainstItself) {
  const std::filesystem::path wide = test() / "wide.png";
  write_png(wide, make_image(1, 1));
  std::fstream file(wide, std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(16);
  file.write("\0\1\0\0\0\0\0\1", 8);  // 65,536 x 1
  file.seekp(29);
  file.write("\xe4\x10\x74\x8f", 4);  // and the checksum of that header
  file.close();
  const RunOutcome outcome = run_kerf({"diff", wide, wide});
  EXPECT_EQ(outcome.exit, 2);
  EXPECT_THAT(outcome.out, HasSubstr("65536x1"));
}

TEST_F(DiffProgram, AFileAgainstAFolderIsRefused) {
  const RunOutcome outcome = run_kerf({"diff", reference(), in_test(0)});
  EXPECT_EQ(outcome.exit, 2);
  EXPECT_THAT(outcome.err, HasSubstr("give two files or two folders"));
}

TEST_F(DiffProgram, WrongOptionsSayWhatIsRight) {
  EXPECT_THAT(diff({"--gate", "flap"}).err, HasSubstr("did you mean 'flip'?"));
  EXPECT_THAT(diff({"--flip-limit", "2"}).err, HasSubstr("is not a number from 0 to 1"));
}

TEST_F(DiffProgram, AnInterruptedSequenceIsNoted) {
  manifests(R"({"frames": [{"file": "f0.png"}]})", R"({"complete": false, "frames": [{"file": "f0.png"}]})");
  const RunOutcome outcome = diff();
  EXPECT_EQ(outcome.exit, 0);
  EXPECT_THAT(outcome.out, HasSubstr("a sequence that was not finished"));
}

constexpr const char* kManifest = R"({"seed": 1, "config": {"merge": 1}, "frames": [
    {"file": "f0.png", "step": 10, "pixel_hash": "1"}, {"file": "f1.png", "step": 11, "pixel_hash": "2"}]})";

TEST_F(DiffProgram, WhatManifestsSayOfTheFramesMustBeTheSame) {
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string text = kManifest;
    text.replace(text.find(from), from.size(), to);
    manifests(kManifest, text);
    return diff();
  };
  EXPECT_EQ(changed("\"2\"", "\"3\"").exit, 0) << "pixels are compared themselves";
  const auto expect_said = [&](const RunOutcome& outcome, const std::string& what) {
    EXPECT_EQ(outcome.exit, 1);
    EXPECT_THAT(outcome.out, HasSubstr("frames.json: " + what + "\n"));
    EXPECT_THAT(outcome.err, HasSubstr("0 of 3 frames differ; 1 manifest differs"));
    EXPECT_THAT(outcome.out + outcome.err, Not(HasSubstr("the same")));
  };
  expect_said(changed("11", "99"), "f1.png: step: 11 and 99");
  expect_said(changed("\"seed\": 1", "\"seed\": 2"), "seed: 1 and 2");
  expect_said(changed("\"merge\": 1", "\"merge\": 0"), "config.merge: 1 and 0");
  expect_said(changed("\"seed\"", "\"seat\""), "seed: 1 and nothing");
  expect_said(changed(R"({"file": "f0.png", "step": 10, "pixel_hash": "1"}, )", ""),
              "it does not name f0.png");
  std::filesystem::remove(test() / "frames.json");
  expect_said(diff(), "it is missing");
  std::filesystem::rename(reference() / "frames.json", test() / "frames.json");
  expect_said(diff(), "it has no reference");
}

TEST_F(DiffProgram, ApprovingTakesTheManifest) {
  manifests(kManifest, R"({"frames": [{"file": "f0.png"}]})");
  const RunOutcome outcome = diff({"--approve"});
  EXPECT_EQ(outcome.exit, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("approved frames.json"));
  EXPECT_EQ(diff().exit, 0);
  std::filesystem::remove(test() / "frames.json");
  EXPECT_EQ(diff({"--approve"}).exit, 1);
  EXPECT_TRUE(std::filesystem::exists(reference() / "frames.json"));
}

}  // namespace
}  // namespace kerf::test
