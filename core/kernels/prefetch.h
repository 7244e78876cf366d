#pragma once

#include <cstddef>

namespace kerf {

/// How many turns of a loop before its use a value that lies anywhere is asked for.
inline constexpr std::size_t kPrefetchAhead = 16;

/// Asks for the memory at an address that will be read soon. A hint: any address will do.
inline void prefetch(const void* address) {
#ifdef __GNUC__
  __builtin_prefetch(address);
#else
  (void)address;
#endif
}

}  // namespace kerf
