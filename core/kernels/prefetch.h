#pragma once

#include <hwy/cache_control.h>

#include <cstddef>
#include <span>

namespace kerf {

/// The number of turns of a loop by which a value is prefetched before its use.
inline constexpr std::size_t kPrefetchAhead = 32;

/// The bytes of a core's own cache that remain beside other data.
inline constexpr std::size_t kOwnCache = std::size_t{3} << 18U;
/// The bytes on as many pages as a processor's TLB holds (about 1,500 of 4 KB), with some to spare.
inline constexpr std::size_t kOwnPages = std::size_t{3} << 20U;

/// Whether values read in any order are so many that reads wait for memory, and prefetching each pays.
template <class T>
bool exceeds(std::span<const T> values, std::size_t bytes) {
  return values.size_bytes() > bytes;
}

/// Prefetches the memory at an address that will be read soon. A hint: any address will do. Always inlined:
/// GCC takes a function that does nothing else for one without effect, and drops the calls.
template <class T>
HWY_INLINE void prefetch(const T* address) {
  hwy::Prefetch(address);
}

}  // namespace kerf
