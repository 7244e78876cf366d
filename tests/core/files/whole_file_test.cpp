#include "core/files/whole_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <stdexcept>

#include "tests/support/temporary_folder.h"

namespace kerf {
namespace {

using ::testing::HasSubstr;

std::string error_of(const std::function<void()>& read) {
  try {
    read();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(WholeFile, HasAllBytes) {
  const test::TemporaryFolder folder;
  std::string bytes(200'000, 'a');
  bytes[70'000] = '\0';
  bytes[199'999] = '\n';
  std::ofstream(folder.path() / "a", std::ios::binary) << bytes;
  EXPECT_EQ(read_whole_file(folder.path() / "a"), bytes);
  EXPECT_EQ(read_whole_file(folder.path() / "a", bytes.size()), bytes);
  EXPECT_THAT(error_of([&] { read_whole_file(folder.path() / "a", bytes.size() - 1); }),
              HasSubstr("a: it has more than 199999 bytes"));
  EXPECT_EQ(read_whole_file_if_there(folder.path() / "a"), bytes);
  std::ofstream(folder.path() / "empty").flush();
  EXPECT_EQ(read_whole_file(folder.path() / "empty"), "");
}

TEST(WholeFile, SaysWhyItCannotBeRead) {
  const test::TemporaryFolder folder;
  const std::filesystem::path missing = folder.path() / "missing";
  EXPECT_EQ(read_whole_file_if_there(missing), std::nullopt);
  EXPECT_EQ(read_whole_file_if_there("/dev/null/kerf/debug-window"), std::nullopt);
  EXPECT_EQ(error_of([&] { read_whole_file(missing); }),
            "cannot read " + missing.string() + ": No such file or directory");
  const std::string of_folder = "cannot read " + folder.path().string() + ": Is a directory";
  EXPECT_EQ(error_of([&] { read_whole_file(folder.path()); }), of_folder);
  EXPECT_EQ(error_of([&] { read_whole_file_if_there(folder.path()); }), of_folder);
}

TEST(WholeFile, ADeviceWithoutEndIsRefused) {
  EXPECT_THAT(error_of([] { read_whole_file("/dev/zero", 100'000); }), HasSubstr("more than 100000 bytes"));
}

}  // namespace
}  // namespace kerf
