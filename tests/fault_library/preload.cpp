// A library for LD_PRELOAD that makes one call of a program, or of a program that it starts, fail or the last
// that is made. It counts the calls by which files below a folder come into being and get their contents and
// names, in the order in which they are made by all processes together.
//
// KERF_FAULT_FOLDER  calls on files below it count
// KERF_FAULT_COUNT   a file with a 64-bit number in it, the calls so far, which is shared by the processes
// KERF_FAULT_AT      which call, from 1; 0: none, so that they are counted
// KERF_FAULT_ERROR   the errno of the call, which is not made then; "kill": the process is killed instead

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdarg>
#include <cstdint>
#include <cstdlib>
#include <cstring>

namespace {

template <class Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

const char* setting(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

using Open = int(const char*, int, ...);

/// Null if the settings are incomplete.
std::atomic<std::uint64_t>* shared_count() {
  static std::atomic<std::uint64_t>* const count = [] {
    const int file = next<Open>("open")(setting("KERF_FAULT_COUNT"), O_RDWR | O_CLOEXEC);
    if (file < 0) return static_cast<std::atomic<std::uint64_t>*>(nullptr);
    void* const memory = ::mmap(nullptr, sizeof(std::uint64_t), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    ::close(file);
    return memory == MAP_FAILED ? nullptr : static_cast<std::atomic<std::uint64_t>*>(memory);
  }();
  return count;
}

bool is_below_folder(const char* path) {
  static const char* const folder = setting("KERF_FAULT_FOLDER");
  const std::size_t length = std::strlen(folder);
  return length > 0 && std::strncmp(path, folder, length) == 0 && (path[length] == '/' || path[length] == 0);
}

bool is_below_folder(int file) {
  char link[32] = "/proc/self/fd/";
  char digits[12];
  int count = 0;
  for (int rest = file; rest > 0 || count == 0; rest /= 10)
    digits[count++] = static_cast<char>('0' + rest % 10);
  char* end = link + std::strlen(link);
  while (count > 0) *end++ = digits[--count];
  *end = 0;
  char path[PATH_MAX];
  const ssize_t length = ::readlink(link, path, sizeof path - 1);
  if (length < 0) return false;
  path[length] = 0;
  return is_below_folder(path);
}

/// Counts a call. True if it must fail, with errno set.
bool fails() {
  static const std::uint64_t at = std::strtoull(setting("KERF_FAULT_AT"), nullptr, 10);
  static const bool kills = std::strcmp(setting("KERF_FAULT_ERROR"), "kill") == 0;
  static const int error = std::atoi(setting("KERF_FAULT_ERROR"));
  std::atomic<std::uint64_t>* const count = shared_count();
  if (count == nullptr || count->fetch_add(1) + 1 != at) return false;
  if (kills) ::raise(SIGKILL);
  errno = error;
  return true;
}

template <class Place>
bool fails(Place place) {
  return is_below_folder(place) && fails();
}

bool creates(int flags) { return (flags & O_CREAT) != 0; }

mode_t mode_of(int flags, std::va_list arguments) { return creates(flags) ? va_arg(arguments, mode_t) : 0; }

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
  std::va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = mode_of(flags, arguments);
  va_end(arguments);
  if (creates(flags) && fails(path)) return -1;
  return next<Open>("open")(path, flags, mode);
}

int open64(const char* path, int flags, ...) {
  std::va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = mode_of(flags, arguments);
  va_end(arguments);
  if (creates(flags) && fails(path)) return -1;
  return next<Open>("open64")(path, flags, mode);
}

ssize_t write(int file, const void* bytes, std::size_t count) {
  if (fails(file)) return -1;
  return next<ssize_t(int, const void*, std::size_t)>("write")(file, bytes, count);
}

ssize_t writev(int file, const struct iovec* parts, int count) {
  if (fails(file)) return -1;
  return next<ssize_t(int, const struct iovec*, int)>("writev")(file, parts, count);
}

ssize_t pwrite(int file, const void* bytes, std::size_t count, off_t place) {
  if (fails(file)) return -1;
  return next<ssize_t(int, const void*, std::size_t, off_t)>("pwrite")(file, bytes, count, place);
}

ssize_t pwrite64(int file, const void* bytes, std::size_t count, off64_t place) {
  if (fails(file)) return -1;
  return next<ssize_t(int, const void*, std::size_t, off64_t)>("pwrite64")(file, bytes, count, place);
}

int ftruncate(int file, off_t size) {
  if (fails(file)) return -1;
  return next<int(int, off_t)>("ftruncate")(file, size);
}

int ftruncate64(int file, off64_t size) {
  if (fails(file)) return -1;
  return next<int(int, off64_t)>("ftruncate64")(file, size);
}

int fsync(int file) {
  if (fails(file)) return -1;
  return next<int(int)>("fsync")(file);
}

int fdatasync(int file) {
  if (fails(file)) return -1;
  return next<int(int)>("fdatasync")(file);
}

int syncfs(int file) noexcept {
  if (fails(file)) return -1;
  return next<int(int)>("syncfs")(file);
}

int rename(const char* from, const char* to) noexcept {
  if (fails(to)) return -1;
  return next<int(const char*, const char*)>("rename")(from, to);
}

int renameat2(int from_folder, const char* from, int to_folder, const char* to, unsigned flags) noexcept {
  if (fails(to)) return -1;
  return next<int(int, const char*, int, const char*, unsigned)>("renameat2")(from_folder, from, to_folder,
                                                                              to, flags);
}

int link(const char* from, const char* to) noexcept {
  if (fails(to)) return -1;
  return next<int(const char*, const char*)>("link")(from, to);
}

int mkdir(const char* path, mode_t mode) noexcept {
  if (fails(path)) return -1;
  return next<int(const char*, mode_t)>("mkdir")(path, mode);
}

}  // extern "C"
