#pragma once

#include <hwy/cache_control.h>

#include <cstddef>
#include <span>

#include "core/base/tuning.h"

namespace kerf {

/// Whether values take more memory than that. Beyond a cache, a loop that reads them in any order waits for
/// many of them, so that it pays to ask for each ahead.
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
