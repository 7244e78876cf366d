#include "viz/debugger/model/opening.h"

#include <algorithm>

namespace kerf {

std::uint32_t opening_step(std::span<const StepRow> rows) {
  std::uint32_t most = 0;
  for (const StepRow& row : rows) most = std::max(most, row.statistics.leaves);
  const auto grown = std::ranges::find_if(rows, [&](const StepRow& row) {
    return 5 * std::uint64_t{row.statistics.leaves} >= 4 * std::uint64_t{most};
  });
  return grown == rows.end() ? 0 : grown->step;
}

}  // namespace kerf
