#include "core/recording/writer_lock.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>
#include <string>
#include <system_error>

namespace kerf {
namespace {

/// Names may have 255 bytes. Two that share the first 250 exclude each other, which does no harm.
std::filesystem::path lock_path(const std::filesystem::path& recording) {
  constexpr std::size_t kMostKept = 250;
  return recording.parent_path() / (recording.filename().string().substr(0, kMostKept) + "-lock");
}

struct flock whole_file() {
  struct flock lock = {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  return lock;
}

[[noreturn]] void refuse_second_writer(const std::filesystem::path& recording) {
  throw std::runtime_error(recording.string() +
                           " is being written at this moment; wait until it is done, or choose another name");
}

[[noreturn]] void fail_to_lock(const std::filesystem::path& recording, int error) {
  throw std::runtime_error("cannot open " + recording.string() + ": " +
                           std::generic_category().message(error));
}

/// The last owner removes the file. A process that opened it before that holds a lock that no other sees.
bool is_still_there(int file, const std::filesystem::path& path) {
  struct stat held = {};
  struct stat named = {};
  return ::fstat(file, &held) == 0 && ::stat(path.c_str(), &named) == 0 && held.st_ino == named.st_ino &&
         held.st_dev == named.st_dev;
}

}  // namespace

WriterLock::WriterLock(const std::filesystem::path& recording)
    : path_(lock_path(recording)), owner_(::getpid()) {
  do {
    if (file_ >= 0) ::close(file_);
    file_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (file_ < 0) fail_to_lock(recording, errno);
    struct flock lock = whole_file();
    if (::fcntl(file_, F_OFD_SETLK, &lock) == 0) continue;
    const bool is_taken = errno == EAGAIN || errno == EACCES;
    ::close(file_);
    if (is_taken) refuse_second_writer(recording);
    fail_to_lock(recording, errno);
  } while (!is_still_there(file_, path_));
}

WriterLock::~WriterLock() {
  if (::getpid() == owner_) ::unlink(path_.c_str());
  ::close(file_);
}

bool is_being_written(const std::filesystem::path& recording) {
  const int file = ::open(lock_path(recording).c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW);
  if (file < 0) return errno == EACCES;  // it is there, and what cannot be asked may hold
  struct flock lock = whole_file();
  const bool is_held = ::fcntl(file, F_OFD_GETLK, &lock) != 0 || lock.l_type != F_UNLCK;
  ::close(file);
  return is_held;
}

}  // namespace kerf
