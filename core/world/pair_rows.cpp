#include "core/world/pair_rows.h"

#include <algorithm>
#include <new>

namespace kerf {
namespace {

/// Most rows have few partners, and many of these are ordered already.
void sort_row(Partner* begin, Partner* end) {
  constexpr std::ptrdiff_t kFew = 24;
  if (end - begin > kFew) {
    std::ranges::sort(begin, end);
    return;
  }
  for (Partner* next = begin + 1; next < end; ++next) {
    const Partner partner = *next;
    Partner* place = next;
    for (; place > begin && partner < place[-1]; --place) *place = place[-1];
    *place = partner;
  }
}

}  // namespace

void PairRows::assign(std::span<const Pair> pairs, std::size_t bound) { fill<1>(pairs, bound); }

void PairRows::assign_flagged(std::span<const Pair> pairs, std::size_t bound) { fill<0>(pairs, bound); }

/// `starts_` counts first, then says where the next partner of each row goes; there it is one row ahead.
template <unsigned Shift>
void PairRows::fill(std::span<const Pair> pairs, std::size_t bound) {
  if (pairs.size() > UINT32_MAX) throw std::bad_alloc();
  starts_.assign(bound + 1, 0);
  partners_.resize(pairs.size());
  if (bound == 0) return;
  for (const Pair& pair : pairs) ++starts_[pair.a.index() + 1];
  std::uint32_t start = 0;
  for (std::uint32_t& count : starts_) {
    start += count;
    count = start - count;
  }
  for (const Pair& pair : pairs) partners_[starts_[pair.a.index() + 1]++] = {pair.b.value << Shift};
  sort_rows();
}

bool PairRows::has_same(std::size_t begin, std::size_t end, const PairRows& other) const {
  if (end > rows() || end > other.rows()) return false;
  const std::uint32_t* const one = starts_.data();
  const std::uint32_t* const two = other.starts_.data();
  const std::uint32_t shift = two[begin] - one[begin];
  std::uint32_t differences = 0;
  for (std::size_t a = begin + 1; a <= end; ++a) differences |= (two[a] - one[a]) ^ shift;
  const Partner* const partners = partners_.data();
  return differences == 0 &&
         std::equal(partners + one[begin], partners + one[end], other.partners_.data() + two[begin]);
}

void PairRows::sort_rows() {
  for (std::size_t a = 0; a < rows(); ++a)
    sort_row(partners_.data() + starts_[a], partners_.data() + starts_[a + 1]);
}

}  // namespace kerf
