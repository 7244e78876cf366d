#include "core/world/pair_rows.h"

#include <algorithm>

namespace kerf {
namespace {

/// Most rows have few partners, in runs that are ordered already.
void sort_row(std::span<Partner> row) {
  constexpr std::size_t kFew = 24;
  if (row.size() > kFew) {
    std::ranges::sort(row);
    return;
  }
  for (std::size_t k = 1; k < row.size(); ++k) {
    const Partner partner = row[k];
    std::size_t place = k;
    for (; place > 0 && partner < row[place - 1]; --place) row[place] = row[place - 1];
    row[place] = partner;
  }
}

}  // namespace

void PairRows::assign(std::span<const Pair> pairs, std::size_t bound) { fill<1>(pairs, bound); }

void PairRows::assign_flagged(std::span<const Pair> pairs, std::size_t bound) { fill<0>(pairs, bound); }

/// `starts_` counts first, then says where the next partner of each row goes; there it is one row ahead.
template <unsigned kShift>
void PairRows::fill(std::span<const Pair> pairs, std::size_t bound) {
  starts_.assign(bound + 1, 0);
  partners_.resize(pairs.size());
  if (bound == 0) return;
  for (const Pair& pair : pairs) ++starts_[pair.a.index() + 1];
  std::size_t start = 0;
  for (std::size_t& count : starts_) {
    start += count;
    count = start - count;
  }
  for (const Pair& pair : pairs) partners_[starts_[pair.a.index() + 1]++] = {pair.b.value << kShift};
  sort_rows();
}

void PairRows::sort_rows() {
  for (std::size_t a = 0; a < rows(); ++a)
    sort_row({partners_.data() + starts_[a], partners_.data() + starts_[a + 1]});
}

}  // namespace kerf
