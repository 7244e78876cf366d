#include "frames/support/atomic_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <system_error>

namespace kerf {
namespace {

/// The file under its temporary name, empty.
int open_part(const std::filesystem::path& path) {
  const int file = ::open(part_path(path).c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) fail_to_write(path, errno);
  return file;
}

bool write_all(int file, std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return true;
}

}  // namespace

void fail_to_write(const std::filesystem::path& path, int error) {
  throw std::system_error(error, std::generic_category(), "cannot write " + path.string());
}

std::filesystem::path part_path(const std::filesystem::path& path) {
  constexpr std::size_t kLongestStem = 200;  // names have up to 255 bytes, and SQLite adds some
  return path.parent_path() /
         ("." + path.stem().string().substr(0, kLongestStem) + ".part" + path.extension().string());
}

void write_file_atomically(const std::filesystem::path& path, std::span<const std::uint8_t> bytes) {
  const std::filesystem::path part = part_path(path);
  const int file = open_part(path);
  int error = write_all(file, bytes) ? 0 : errno;
  if (::close(file) != 0 && error == 0) error = errno;
  if (error == 0 && ::rename(part.c_str(), path.c_str()) != 0) error = errno;
  if (error == 0) return;
  ::unlink(part.c_str());
  fail_to_write(path, error);
}

void write_file_atomically(const std::filesystem::path& path, std::string_view text) {
  write_file_atomically(path, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

void copy_file_atomically(const std::filesystem::path& from, const std::filesystem::path& to) {
  std::ifstream file(from, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  if (!file) throw std::runtime_error("cannot read " + from.string());
  write_file_atomically(to, bytes);
}

void check_writable(const std::filesystem::path& path) {
  if (std::filesystem::is_directory(path)) fail_to_write(path, EISDIR);
  ::close(open_part(path));
  ::unlink(part_path(path).c_str());
}

void make_writable_folder(const std::filesystem::path& folder, const std::string& option) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    throw std::runtime_error("cannot make the folder " + folder.string() + ": " + error.message() +
                             "; choose another with " + option);
  }
  const std::filesystem::path trial = folder / ".kerf.trial";
  const int file = ::open(trial.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
  if (file < 0) {
    throw std::runtime_error("cannot write into the folder " + folder.string() + ": " + std::strerror(errno) +
                             "; choose another with " + option);
  }
  ::close(file);
  ::unlink(trial.c_str());
}

}  // namespace kerf
