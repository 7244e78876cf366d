#include "frames/support/memory_use.h"

#include <algorithm>
#include <fstream>
#include <string>
#include <string_view>

namespace kerf {
namespace {

/// The number of KiB after `key` in a file of "Key:   123 kB" lines, in bytes.
std::uint64_t field(const char* path, std::string_view key) {
  std::ifstream file(path);
  std::string word;
  while (file >> word) {
    std::uint64_t kib = 0;
    if (word == key && file >> kib) return kib * 1024;
  }
  return 0;
}

}  // namespace

std::uint64_t own_memory() { return field("/proc/self/smaps_rollup", "Anonymous:"); }

std::uint64_t peak_own_memory() {
  constexpr const char* kStatus = "/proc/self/status";
  const std::uint64_t foreign = field(kStatus, "RssFile:") + field(kStatus, "RssShmem:");
  const std::uint64_t high = field(kStatus, "VmHWM:");
  return std::max(own_memory(), high - std::min(high, foreign));
}

}  // namespace kerf
