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

void PairRows::assign(std::span<const Pair> pairs, std::size_t bound, const PairRows& before) {
  fill<1>(pairs, bound);
  sort_rows(before);
}

void PairRows::assign_flagged(std::span<const Pair> pairs, std::size_t bound, const PairRows& before) {
  fill<0>(pairs, bound);
  sort_rows(before);
}

/// `starts_` counts first, then says where the next partner of each row goes; there it is one row ahead.
template <unsigned Shift>
void PairRows::fill(std::span<const Pair> pairs, std::size_t bound) {
  if (pairs.size() > UINT32_MAX) throw std::bad_alloc();
  starts_.assign(bound + 1, 0);
  arrived_.resize(pairs.size());
  if (bound == 0) return;
  for (const Pair& pair : pairs) ++starts_[pair.a.index() + 1];
  std::uint32_t start = 0;
  for (std::uint32_t& count : starts_) {
    start += count;
    count = start - count;
  }
  for (const Pair& pair : pairs) arrived_[starts_[pair.a.index() + 1]++] = {pair.b.value << Shift};
}

/// Where most objects rest, most rows arrive as before: some of them are compared at a time, and copied.
void PairRows::sort_rows(const PairRows& before) {
  constexpr std::size_t kRun = 8;
  partners_.resize(arrived_.size());
  const bool may_be_same = before.arrived_.size() == before.partners_.size();
  for (std::size_t begin = 0; begin < rows(); begin += kRun) {
    const std::size_t end = std::min(begin + kRun, rows());
    const std::uint32_t start = starts_[begin];
    if (may_be_same && has_same(&PairRows::arrived_, begin, end, before)) {
      std::copy_n(before.partners_.data() + before.starts_[begin], starts_[end] - start,
                  partners_.data() + start);
      continue;
    }
    std::copy_n(arrived_.data() + start, starts_[end] - start, partners_.data() + start);
    for (std::size_t a = begin; a < end; ++a)
      sort_row(partners_.data() + starts_[a], partners_.data() + starts_[a + 1]);
  }
}

bool PairRows::has_same(Partners PairRows::*partners, std::size_t begin, std::size_t end,
                        const PairRows& other) const {
  if (end > rows() || end > other.rows()) return false;
  const std::uint32_t* const one = starts_.data();
  const std::uint32_t* const two = other.starts_.data();
  const std::uint32_t shift = two[begin] - one[begin];
  std::uint32_t differences = 0;
  for (std::size_t a = begin + 1; a <= end; ++a) differences |= (two[a] - one[a]) ^ shift;
  const Partner* const ours = (this->*partners).data();
  return differences == 0 &&
         std::equal(ours + one[begin], ours + one[end], (other.*partners).data() + two[begin]);
}

}  // namespace kerf
