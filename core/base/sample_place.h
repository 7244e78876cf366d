#pragma once

#include <cstddef>
#include <cstdint>

namespace kerf {

/// The k-th place of a sample of `count` things. The strides are golden ratios: fixed ones can alias with a
/// pattern of the ids, as when every 16th object sleeps.
constexpr std::size_t sample_place(std::uint32_t k, std::size_t count) {
  constexpr std::uint32_t kGolden = 0x9E3779B9U;
  return (std::uint64_t{k * kGolden} * count) >> 32U;
}

}  // namespace kerf
