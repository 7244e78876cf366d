#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace kerf {

/// Of 64 entries: bit k says that entry j + k overlaps entry i as far as bytes tell.
struct FoundRow {
  std::uint64_t bits;
  std::uint32_t i;
  std::uint32_t j;
};

/// Rows that are confirmed in one go.
inline constexpr std::size_t kConfirmAt = 512;
/// Room for them and for two that are read beyond the last.
using Findings = std::array<FoundRow, kConfirmAt + 2>;

}  // namespace kerf
