#include "viz/image/png.h"

#include <gmock/gmock.h>
#include <sys/resource.h>

#include <csignal>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <vector>

#include "core/base/random.h"
#include "tests/support/temporary_folder.h"
#include "tests/viz/message_of.h"

namespace kerf {
namespace {

using testing::HasSubstr;

/// Noise, so that no compression or filter can pass by luck.
Image noise(int width, int height, bool opaque) {
  Random random(7);
  Image image = make_image(width, height);
  for (std::size_t i = 0; i < image.rgba.size(); ++i)
    if (!opaque || i % 4 != 3) image.rgba[i] = static_cast<std::uint8_t>(random.below(256));
  return image;
}

std::vector<std::uint8_t> bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void write_bytes(const std::filesystem::path& path, const std::vector<std::uint8_t>& bytes) {
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

std::string read_error(const std::filesystem::path& path) {
  return test::message_of<std::runtime_error>([&] { read_png(path); });
}

/// Files of this process can grow to `bytes` and no further, as on a full disk.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) : old_handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &old_limit_);
    const rlimit limit{bytes, old_limit_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &old_limit_);
    std::signal(SIGXFSZ, old_handler_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  void (*old_handler_)(int);
  rlimit old_limit_{};
};

TEST(Png, GivesBackWhatWasWritten) {
  const test::TemporaryFolder folder;
  for (const bool opaque : {true, false}) {
    for (const auto& [width, height] : {std::pair{1, 1}, {3, 2}, {67, 41}, {640, 3}}) {
      const Image image = noise(width, height, opaque);
      write_png(folder.path() / "a.png", image);
      EXPECT_EQ(read_png(folder.path() / "a.png"), image) << width << "x" << height << " opaque " << opaque;
    }
  }
}

TEST(Png, LeavesOnlyTheFileItself) {
  const test::TemporaryFolder folder;
  write_png(folder.path() / "a.png", make_image(8, 8));
  write_png(folder.path() / "a.png", make_image(9, 9));
  const std::filesystem::directory_iterator files(folder.path());
  EXPECT_EQ(std::distance(begin(files), end(files)), 1);
  EXPECT_EQ(read_png(folder.path() / "a.png").width, 9);
}

TEST(Png, FullDiskIsAnErrorAndLeavesNothing) {
  const test::TemporaryFolder folder;
  const FullDisk full(4096);
  const auto path = folder.path() / "a.png";
  const std::string error =
      test::message_of<std::runtime_error>([&] { write_png(path, noise(200, 200, true)); });
  EXPECT_THAT(error, HasSubstr(path.string()));
  EXPECT_THAT(error, HasSubstr("File too large"));
  EXPECT_TRUE(folder.is_empty());
}

TEST(Png, FullDiskKeepsTheEarlierFile) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "a.png";
  write_png(path, make_image(8, 8));
  const FullDisk full(4096);
  EXPECT_THROW(write_png(path, noise(200, 200, true)), std::runtime_error);
  EXPECT_EQ(read_png(path), make_image(8, 8));
}

TEST(Png, RefusesWhatCannotBeAFile) {
  const test::TemporaryFolder folder;
  EXPECT_THROW(write_png(folder.path() / "none" / "a.png", make_image(2, 2)), std::runtime_error);
  EXPECT_THROW(write_png(folder.path(), make_image(2, 2)), std::runtime_error);
  EXPECT_THROW(write_png("/dev/full", make_image(2, 2)), std::runtime_error);
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

TEST(Png, RefusesAnImageThatIsNone) {
  const test::TemporaryFolder folder;
  EXPECT_THROW(write_png(folder.path() / "a.png", Image{}), std::runtime_error);
  EXPECT_THROW(write_png(folder.path() / "a.png", Image{2, 2, {1, 2, 3}}), std::runtime_error);
  EXPECT_TRUE(folder.is_empty());
}

TEST(Png, EveryTruncatedFileIsRefused) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "a.png";
  write_png(path, noise(9, 7, true));
  std::vector<std::uint8_t> bytes = bytes_of(path);
  while (!bytes.empty()) {
    bytes.pop_back();
    write_bytes(path, bytes);
    EXPECT_THAT(read_error(path), HasSubstr(path.string())) << bytes.size() << " bytes";
  }
}

TEST(Png, EveryDamagedByteIsNoticed) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "a.png";
  write_png(path, noise(5, 4, true));
  const std::vector<std::uint8_t> bytes = bytes_of(path);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::vector<std::uint8_t> damaged = bytes;
    damaged[i] ^= 0x20U;
    write_bytes(path, damaged);
    EXPECT_NE(read_error(path), "") << "byte " << i;
  }
}

/// Allowed, but rare: found by fuzzing.
TEST(Png, AnEmptyChunkOfPictureDataIsRead) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "a.png";
  write_png(path, noise(5, 4, true));
  std::vector<std::uint8_t> bytes = bytes_of(path);
  constexpr std::ptrdiff_t kBehindHeader = 33;
  const std::vector<std::uint8_t> empty{0, 0, 0, 0, 'I', 'D', 'A', 'T', 0x35, 0xAF, 0x06, 0x1E};
  bytes.insert(bytes.begin() + kBehindHeader, empty.begin(), empty.end());
  write_bytes(path, bytes);
  EXPECT_EQ(read_png(path), noise(5, 4, true));
}

TEST(Png, SaysWhatIsWrong) {
  const test::TemporaryFolder folder;
  EXPECT_THAT(read_error(folder.path() / "none.png"), HasSubstr("No such file"));
  EXPECT_THAT(read_error(folder.path()), HasSubstr("folder"));
  EXPECT_THAT(read_error("/dev/zero"), HasSubstr("not a PNG"));
  EXPECT_THAT(read_error("/dev/null"), HasSubstr("empty"));
  write_png(folder.path() / "a.png", noise(20, 20, true));
  std::vector<std::uint8_t> bytes = bytes_of(folder.path() / "a.png");
  bytes.resize(bytes.size() / 2);
  write_bytes(folder.path() / "a.png", bytes);
  EXPECT_THAT(read_error(folder.path() / "a.png"), HasSubstr("truncated"));
}

TEST(PixelHash, SeesSizeAndEveryPixel) {
  const Image image = noise(31, 17, true);
  EXPECT_EQ(pixel_hash(image), pixel_hash(Image(image)));
  for (std::size_t i = 0; i < image.rgba.size(); i += 5) {
    Image other = image;
    other.rgba[i] ^= 1U;
    EXPECT_NE(pixel_hash(other), pixel_hash(image)) << "byte " << i;
  }
  EXPECT_NE(pixel_hash(make_image(4, 6)), pixel_hash(make_image(6, 4)));
}

}  // namespace
}  // namespace kerf
