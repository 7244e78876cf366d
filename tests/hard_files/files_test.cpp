// F1 to F3: files that lie, disks that are full and processes that are killed, for scenes and parameters by
// name, frames and images. The tests of viz/ and frames/ go further into each.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <string>
#include <thread>

#include "frames/sequence/manifest.h"
#include "frames/support/errors.h"
#include "tests/frames/program.h"
#include "viz/image/png.h"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;

std::string bytes_of(const std::filesystem::path& file) { return test::read_text(file); }

void write_bytes(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

/// What `read_png` says of a file that it must refuse.
std::string refusal(const std::filesystem::path& file) {
  try {
    read_png(file);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "it was read";
}

/// The address space that the process takes at most from now on, until the end of the scope.
class MemoryLimit {
 public:
  explicit MemoryLimit(rlim_t bytes_more) {
    getrlimit(RLIMIT_AS, &before_);
    std::ifstream statm("/proc/self/statm");
    rlim_t pages = 0;
    statm >> pages;
    const rlimit limit{pages * 4096 + bytes_more, before_.rlim_max};
    setrlimit(RLIMIT_AS, &limit);
  }
  ~MemoryLimit() { setrlimit(RLIMIT_AS, &before_); }
  MemoryLimit(const MemoryLimit&) = delete;
  MemoryLimit& operator=(const MemoryLimit&) = delete;

 private:
  rlimit before_{};
};

TEST(HardFiles, F1_ATruncatedImageIsRefusedByName) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "frame.png";
  write_png(file, make_image(40, 30, 0x336699ffU));
  const std::string whole = bytes_of(file);
  for (const std::size_t length : {std::size_t{0}, std::size_t{7}, whole.size() / 2, whole.size() - 1}) {
    write_bytes(file, whole.substr(0, length));
    EXPECT_THAT(refusal(file), HasSubstr("frame.png"));
  }
}

TEST(HardFiles, F1_ALyingImageTakesNoMemory) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "frame.png";
  // 16384 by 16384 pixels, 1 GB, in a file of some fifty bytes; the header's checksum is right.
  const std::string lie(
      "\x89PNG\r\n\x1a\n"
      "\0\0\0\x0dIHDR\0\0\x40\0\0\0\x40\0\x08\x06\0\0\0\xa9\xc8\x10\x84"
      "\0\0\0\0IDAT\x35\xaf\x06\x1e"
      "\0\0\0\0IEND\xae\x42\x60\x82",
      57);
  write_bytes(file, lie);
  const MemoryLimit limit(rlim_t{200} << 20U);
  EXPECT_THAT(refusal(file), HasSubstr("frame.png"));
}

TEST(HardFiles, F1_ASceneOrAParameterThatIsNoneIsNamed) {
  const TemporaryFolder folder;
  const RunOutcome scene = test::run_kerf({"render", "pyle", "--out", folder.path() / "a"});
  EXPECT_EQ(scene.exit, kExitUnusable);
  EXPECT_THAT(scene.err, HasSubstr("pyle"));
  EXPECT_THAT(scene.err, HasSubstr("pile")) << "what was meant";
  const RunOutcome parameter =
      test::run_kerf({"render", "pile", "--config", "max_height=1e9", "--out", folder.path() / "b"});
  EXPECT_EQ(parameter.exit, kExitUnusable);
  EXPECT_THAT(parameter.err, HasSubstr("max_height"));
  EXPECT_TRUE(folder.files().empty());
}

TEST(HardFiles, F2_AFullDeviceAndAClosedPipeAreErrors) {
  const std::string program = KERF_PROGRAM;
  const RunOutcome full = Process({"sh", "-c", program + " scenes > /dev/full"}).wait();
  EXPECT_NE(full.exit, 0);
  EXPECT_THAT(full.err, HasSubstr("kerf"));
  // The reader is gone before the first word.
  const RunOutcome pipe =
      Process({"bash", "-c", "(sleep 0.3; " + program + " scenes) | true; exit ${PIPESTATUS[0]}"}).wait();
  EXPECT_NE(pipe.exit, 0);
}

TEST(HardFiles, F2_AFileThatMayNotGrowLeavesNothing) {
  const TemporaryFolder folder;
  const RunOutcome outcome = test::run_kerf(
      {"render", "pile", "--objects", "30", "--steps", "1:3:1", "--size", "320x240", "--out", folder.path()},
      {2000, ""});
  EXPECT_EQ(outcome.exit, kExitUnusable);
  EXPECT_THAT(outcome.err, HasSubstr("pile_00000"));
  for (const std::string& file : folder.files())
    EXPECT_FALSE(file.ends_with(".png")) << file << " has a final name and is not complete";
}

bool is_frame(const std::string& name) { return name.starts_with("pile_") && name.ends_with(".png"); }

/// Until the first frame of a sequence is there; false after a minute without.
bool wait_for_a_frame(const TemporaryFolder& folder) {
  return test::holds_within_a_minute([&] { return std::ranges::any_of(folder.files(), is_frame); });
}

/// Killed without a warning at different times after the first frame: each file that has its final name
/// opens, and only a sequence that was finished claims so.
TEST(HardFiles, F3_AKilledSequenceHoldsOnlyWholeFrames) {
  for (const int milliseconds : {0, 7, 60, 150, 400}) {
    const TemporaryFolder folder;
    Process process(test::kerf_command({"render", "pile", "--steps", "1:1000000:1", "--objects", "50",
                                        "--size", "320x240", "--out", folder.path()}));
    ASSERT_TRUE(wait_for_a_frame(folder));
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    process.signal(SIGKILL);
    EXPECT_EQ(process.wait().exit, 128 + SIGKILL);
    if (std::filesystem::exists(folder.path() / kManifestName)) {
      const Manifest manifest = read_manifest(folder.path());
      EXPECT_FALSE(manifest.complete);
      for (const FrameRecord& frame : manifest.frames)
        EXPECT_EQ(pixel_hash(read_png(folder.path() / frame.file)), frame.pixel_hash) << frame.file;
    }
    for (const std::string& name : folder.files())
      if (is_frame(name)) {
        EXPECT_EQ(read_png(folder.path() / name).width, 320) << name;
      }
  }
}

}  // namespace
}  // namespace kerf::test
