#include "frames/support/machine.h"

#include <sys/utsname.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <string>
#include <string_view>

#include "frames/support/version.h"

namespace kerf {
namespace {

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  std::string line;
  while (std::getline(file, line))
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown";
}

/// The widest vectors that processor and system support.
std::string vectors() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f")) return "AVX-512";
  if (__builtin_cpu_supports("avx2")) return "AVX2";
  return "SSE2";
#else
  return "unknown";
#endif
}

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

nlohmann::ordered_json describe_machine() {
  utsname system{};
  uname(&system);
  std::array<double, 3> load{};
  getloadavg(load.data(), static_cast<int>(load.size()));
  const auto pages = static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES));
  return {{"processor", processor()},
          {"vectors", vectors()},
          {"cores", sysconf(_SC_NPROCESSORS_ONLN)},
          {"memory_bytes", pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE))},
          {"system", std::string(system.sysname) + " " + system.release},
          {"compiler", "g++ " __VERSION__},
          {"kerf", version()},
          {"load_average", load[0]}};
}

std::uint64_t own_memory() { return field("/proc/self/smaps_rollup", "Anonymous:"); }

std::uint64_t peak_own_memory() {
  constexpr const char* kStatus = "/proc/self/status";
  const std::uint64_t foreign = field(kStatus, "RssFile:") + field(kStatus, "RssShmem:");
  const std::uint64_t high = field(kStatus, "VmHWM:");
  return std::max(own_memory(), high - std::min(high, foreign));
}

}  // namespace kerf
