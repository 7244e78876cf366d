#pragma once

#include <hwy/cache_control.h>

#include <cstddef>
#include <span>

namespace kerf {

/// How many turns of a loop before its use a value that lies anywhere is asked for.
inline constexpr std::size_t kPrefetchAhead = 32;

/// What a core's own cache holds beside other things, in bytes.
inline constexpr std::size_t kOwnCache = std::size_t{3} << 18U;
/// What lies on as few pages as processors keep at hand (about 1,500 of 4 KB), with some to spare.
inline constexpr std::size_t kOwnPages = std::size_t{3} << 20U;

/// Whether who reads values in any order waits for many of them, so that it pays to ask for each ahead.
template <class T>
bool exceeds(std::span<const T> values, std::size_t bytes) {
  return values.size_bytes() > bytes;
}

/// Asks for the memory at an address that will be read soon. A hint: any address will do. Always inlined: of
/// a function that does nothing else GCC thinks that it does nothing, and drops the calls.
template <class T>
HWY_INLINE void prefetch(const T* address) {
  hwy::Prefetch(address);
}

}  // namespace kerf
