#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/ids.h"

namespace kerf {

/// The second object of a pair together with the pair's flag, in an order by the object.
struct Partner {
  std::uint32_t value = 0;
  [[nodiscard]] constexpr std::uint32_t index() const { return value >> 1U; }
  [[nodiscard]] constexpr bool is_flagged() const { return (value & 1U) != 0; }
  friend constexpr auto operator<=>(Partner, Partner) = default;
};
constexpr Partner make_partner(std::uint32_t index, bool flagged) {
  return {index << 1U | (flagged ? 1U : 0U)};
}

/// The pairs of a step, ordered: a row of partners for each object. Counting makes the rows, since indices
/// are dense; each is sorted by itself, unless its partners come as they came in the step before.
class PairRows {
 public:
  /// Objects have indices below `bound`. `before`: rows of which most may be the same. Throws std::bad_alloc
  /// for 2^32 pairs or more.
  void assign(std::span<const Pair> pairs, std::size_t bound, const PairRows& before = {});
  /// The same, with `b` of each pair the value of a Partner.
  void assign_flagged(std::span<const Pair> pairs, std::size_t bound, const PairRows& before = {});

  [[nodiscard]] std::size_t size() const { return partners_.size(); }
  /// All rows, one behind the other.
  [[nodiscard]] std::span<const Partner> partners() const { return partners_; }
  /// The place behind the row of an object, which need not have one.
  [[nodiscard]] std::size_t end_of(std::size_t a) const {
    return a < rows() ? starts_[a + 1] : partners_.size();
  }
  [[nodiscard]] std::size_t rows() const { return starts_.empty() ? 0 : starts_.size() - 1; }
  [[nodiscard]] std::span<const Partner> row(std::size_t a) const {
    return {partners_.data() + starts_[a], partners_.data() + starts_[a + 1]};
  }
  /// Whether the rows of some objects are those of the other's. False for rows that are not there.
  [[nodiscard]] bool has_same(std::size_t begin, std::size_t end, const PairRows& other) const {
    return has_same(&PairRows::partners_, begin, end, other);
  }
  /// Drops the pairs of which `keep(a, partner)` is false; asks in order.
  template <class Keep>
  void filter(Keep keep);

 private:
  using Partners = std::vector<Partner>;
  template <unsigned Shift>
  void fill(std::span<const Pair> pairs, std::size_t bound);
  void sort_rows(const PairRows& before);
  [[nodiscard]] bool has_same(Partners PairRows::*partners, std::size_t begin, std::size_t end,
                              const PairRows& other) const;

  std::vector<std::uint32_t> starts_;  ///< by object: where its row begins; one more at the end
  Partners partners_;
  Partners arrived_;  ///< the partners of each row in the order of the pairs; none after `filter`
};

template <class Keep>
void PairRows::filter(Keep keep) {
  std::uint32_t end = 0;
  std::uint32_t begin = 0;
  for (std::uint32_t a = 0; a < rows(); ++a) {
    const std::uint32_t row_end = starts_[a + 1];
    for (std::uint32_t k = begin; k < row_end; ++k)
      if (keep(a, partners_[k])) partners_[end++] = partners_[k];
    starts_[a + 1] = end;
    begin = row_end;
  }
  partners_.resize(end);
  arrived_.clear();
}

/// Calls `lost(a, k)` for each pair that only `before` has, `gained(a, i)` for each that only `now` has, in
/// order of the objects; k and i are places in `partners()` of before and of now.
template <class Lost, class Gained>
void compare_rows(const PairRows& before, const PairRows& now, Lost lost, Gained gained) {
  constexpr std::size_t kMany = 16;
  const Partner* const old = before.partners().data();
  const Partner* const next = now.partners().data();
  const std::size_t rows = std::max(before.rows(), now.rows());
  std::size_t k = 0;
  std::size_t i = 0;
  for (std::size_t a = 0; a < rows; ++a) {
    if (a % kMany == 0 && a + kMany < rows && before.has_same(a, a + kMany, now)) {
      a += kMany - 1;
      k = before.end_of(a);
      i = now.end_of(a);
      continue;
    }
    const std::size_t old_end = before.end_of(a);
    const std::size_t next_end = now.end_of(a);
    while (k < old_end || i < next_end) {
      if (i == next_end || (k < old_end && old[k] < next[i])) {
        lost(static_cast<std::uint32_t>(a), k++);
      } else if (k == old_end || next[i] < old[k]) {
        gained(static_cast<std::uint32_t>(a), i++);
      } else {
        ++k;
        ++i;
      }
    }
  }
}

}  // namespace kerf
