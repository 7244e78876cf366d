#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace kerf {

/// The places of two entries that overlap as far as bytes tell.
struct FoundAt {
  std::uint32_t i;
  std::uint32_t j;
};

/// Findings that are confirmed in one go.
inline constexpr std::size_t kConfirmAt = 2048;
/// Room for them, for those of the row that fills it up, and for what is written beyond the last.
using Findings = std::array<FoundAt, kConfirmAt + 64 + 4>;

}  // namespace kerf
