// Writing the pairs of one object with a vector of others, for each of the machine's kinds of vectors:
// included once for each by the kernels (Highway's foreach_target), so there is no `#pragma once`.
#if defined(KERF_WRITE_PAIRS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KERF_WRITE_PAIRS_INL_H
#undef KERF_WRITE_PAIRS_INL_H
#else
#define KERF_WRITE_PAIRS_INL_H
#endif

#include <cstdint>

#include "core/base/ids.h"
#include "core/kernels/compress-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kerf::HWY_NAMESPACE {

/// Writes the pairs of `object` with the chosen `others`; returns the new end.
HWY_INLINE Pair* write_pairs(hn::Vec<Words> object, hn::Vec<Words> others, hn::Mask<Words> reported,
                             Pair* out) {
  const Words w;
  const auto first = compress_words(others, reported);
  hn::StoreInterleaved2(hn::Min(first, object), hn::Max(first, object), w,
                        reinterpret_cast<std::uint32_t*>(out));
  return out + hn::CountTrue(w, reported);
}

}  // namespace kerf::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
