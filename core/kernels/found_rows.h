#pragma once

#include <array>
#include <cstdint>

#include "core/kernels/sweep_tuning.h"

namespace kerf {

/// Of up to 64 entries: bit k says that entry j + k overlaps entry i as far as bytes show.
struct FoundRow {
  std::uint64_t bits;
  std::uint32_t i;
  std::uint32_t j;
};

using tuning::kConfirmListed;  ///< findings, where each row is spread over a list at once
using tuning::kConfirmRows;    ///< rows, where rows are walked

/// Room for findings that are not confirmed yet.
struct Findings {
  std::array<FoundRow, kConfirmRows + 2> rows;           ///< two are read beyond the last
  std::array<std::uint32_t, kConfirmListed + 80> first;  ///< or listed: entry i of each, written 16 at a time
  std::array<std::uint32_t, kConfirmListed + 80> second;  ///< and the entry that it overlaps
};

}  // namespace kerf
