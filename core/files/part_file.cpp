#include "core/files/part_file.h"

#include <fcntl.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <string_view>
#include <system_error>

namespace kerf {
namespace {

constexpr std::string_view kEnding = ".part";
constexpr std::size_t kDigits = 16;
/// Of a name in a folder; SQLite adds up to eight bytes, "-journal".
constexpr std::size_t kLongestName = 255 - 8;
constexpr auto kDatabaseEndings = std::to_array<std::string_view>({"-wal", "-shm", "-journal"});

/// What the names of all parts of a file begin with.
std::string stem_of_parts(const std::filesystem::path& final_path) {
  const std::string name = final_path.filename().string();
  return name.substr(0, kLongestName - 1 - kDigits - kEnding.size()) + ".";
}

/// The file itself where `path` is a link to one.
std::filesystem::path behind_links(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_symlink(path, error)) return path;
  std::filesystem::path target = std::filesystem::canonical(path, error);
  return error ? path : target;
}

std::filesystem::path folder_of(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

/// Calls `work` with an open folder, and throws if it could not.
template <class Work>
void with_folder(const std::filesystem::path& folder, Work work) {
  const int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file < 0) fail_to_write(folder, errno);
  const int error = work(file) == 0 ? 0 : errno;
  ::close(file);
  if (error != 0 && error != EINVAL) fail_to_write(folder, error);  // EINVAL: the file system cannot
}

/// 0, or errno.
int rename_to_a_free_name(const std::filesystem::path& from, const std::filesystem::path& to) {
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return 0;
  if (errno != EINVAL && errno != ENOSYS) return errno;
  std::error_code ignored;  // the file system knows no such rename
  if (std::filesystem::exists(std::filesystem::symlink_status(to, ignored))) return EEXIST;
  return ::rename(from.c_str(), to.c_str()) == 0 ? 0 : errno;
}

}  // namespace

void fail_to_write(const std::filesystem::path& path, int error) {
  throw std::system_error(error, std::generic_category(), "cannot write " + path.string());
}

PartFile::PartFile(const std::filesystem::path& final_path, Replace replace)
    : final_(behind_links(final_path)), replace_(replace) {
  constexpr int kFlags = O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC;
  do {
    part_ = fresh_part_name(final_);
    file_ = ::open(part_.c_str(), kFlags, 0666);
  } while (file_ < 0 && errno == EEXIST);
  if (file_ < 0) fail_to_write(final_path, errno);
}

PartFile::~PartFile() {
  ::close(file_);
  if (is_left_) return;
  ::unlink(part_.c_str());
  for (const std::string_view ending : kDatabaseEndings)
    ::unlink((part_.string() + std::string(ending)).c_str());
}

void PartFile::write(std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail_to_write(final_, errno);
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

void PartFile::write(std::string_view text) {
  write({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

void PartFile::keep(Sync sync) {
  if (sync == Sync::now && ::fsync(file_) != 0) fail_to_write(final_, errno);
  take_name();
  if (sync == Sync::now) sync_folder(folder_of(final_));
}

/// An earlier file's permissions hold for its successor.
void PartFile::take_name() {
  constexpr mode_t kPermissions = 07777;
  struct stat earlier = {};
  if (replace_ == Replace::earlier && ::stat(final_.c_str(), &earlier) == 0)
    static_cast<void>(::fchmod(file_, earlier.st_mode & kPermissions));
  const int error = replace_ == Replace::nothing                   ? rename_to_a_free_name(part_, final_)
                    : ::rename(part_.c_str(), final_.c_str()) == 0 ? 0
                                                                   : errno;
  if (error == EEXIST) {
    leave();
    throw std::system_error(error, std::generic_category(),
                            "cannot write " + final_.string() +
                                ", which has come meanwhile; what was made is in " + part_.string());
  }
  if (error != 0) fail_to_write(final_, error);
}

std::filesystem::path fresh_part_name(const std::filesystem::path& final_path) {
  std::uint64_t number = 0;
  if (::getrandom(&number, sizeof number, 0) != sizeof number) fail_to_write(final_path, errno);
  std::array<char, kDigits + 1> digits{};
  std::snprintf(digits.data(), digits.size(), "%016llx", static_cast<unsigned long long>(number));
  return final_path.parent_path() / (stem_of_parts(final_path) + digits.data() + std::string(kEnding));
}

bool is_part_name(std::string_view name) {
  const auto is_digit = [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); };
  if (!name.ends_with(kEnding)) return false;
  name.remove_suffix(kEnding.size());
  if (name.size() < kDigits + 1 || name[name.size() - kDigits - 1] != '.') return false;
  return std::ranges::all_of(name.substr(name.size() - kDigits), is_digit);
}

std::vector<std::filesystem::path> parts_of(const std::filesystem::path& final_path) {
  const std::filesystem::path file = behind_links(final_path);
  const std::string stem = stem_of_parts(file);
  std::vector<std::filesystem::path> parts;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder_of(file), ignored)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(stem) && name.size() == stem.size() + kDigits + kEnding.size() && is_part_name(name))
      parts.push_back(file.parent_path() / name);
  }
  std::ranges::sort(parts);
  return parts;
}

void sync_folder(const std::filesystem::path& folder) {
  with_folder(folder, [](int file) { return ::fsync(file); });
}

void sync_file_system(const std::filesystem::path& folder) {
  with_folder(folder, [](int file) { return ::syncfs(file); });
}

}  // namespace kerf
