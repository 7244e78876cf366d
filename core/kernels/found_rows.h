#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace kerf {

/// Of 64 entries: bit k says that entry j + k overlaps entry i as far as bytes show.
struct FoundRow {
  std::uint64_t bits;
  std::uint32_t i;
  std::uint32_t j;
};

/// Rows confirmed in one go, where rows are walked.
inline constexpr std::size_t kConfirmRows = 512;
/// Findings confirmed in one go, where each row is spread over a list at once.
inline constexpr std::size_t kConfirmListed = 1024;

/// Room for findings that are not confirmed yet.
struct Findings {
  std::array<FoundRow, kConfirmRows + 2> rows;           ///< two are read beyond the last
  std::array<std::uint32_t, kConfirmListed + 80> first;  ///< or listed: entry i of each, written 16 at a time
  std::array<std::uint32_t, kConfirmListed + 80> second;  ///< and the entry that it overlaps
};

}  // namespace kerf
