#pragma once

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
/// are dense; each is sorted by itself.
class PairRows {
 public:
  /// Objects have indices below `bound`.
  void assign(std::span<const Pair> pairs, std::size_t bound);
  /// The same, with `b` of each pair the value of a Partner.
  void assign_flagged(std::span<const Pair> pairs, std::size_t bound);

  [[nodiscard]] std::size_t size() const { return partners_.size(); }
  [[nodiscard]] std::size_t rows() const { return starts_.empty() ? 0 : starts_.size() - 1; }
  /// Empty beyond the rows.
  [[nodiscard]] std::span<const Partner> row(std::size_t a) const {
    if (a >= rows()) return {};
    return {partners_.data() + starts_[a], partners_.data() + starts_[a + 1]};
  }
  /// Drops the pairs of which `keep(a, partner)` is false; asks in order.
  template <class Keep>
  void filter(Keep keep);

 private:
  template <unsigned kShift>
  void fill(std::span<const Pair> pairs, std::size_t bound);
  void sort_rows();

  std::vector<std::size_t> starts_;  ///< by object: where its row begins; one more at the end
  std::vector<Partner> partners_;
};

template <class Keep>
void PairRows::filter(Keep keep) {
  std::size_t end = 0;
  std::size_t begin = 0;
  for (std::uint32_t a = 0; a < rows(); ++a) {
    const std::size_t row_end = starts_[a + 1];
    for (std::size_t k = begin; k < row_end; ++k)
      if (keep(a, partners_[k])) partners_[end++] = partners_[k];
    starts_[a + 1] = end;
    begin = row_end;
  }
  partners_.resize(end);
}

/// Calls `lost(a, partner)` and `gained(a, partner)` for the differences, in order of the objects.
template <class Lost, class Gained>
void compare_rows(const PairRows& before, const PairRows& now, Lost lost, Gained gained) {
  const std::size_t rows = before.rows() > now.rows() ? before.rows() : now.rows();
  for (std::uint32_t a = 0; a < rows; ++a) {
    const std::span<const Partner> old = before.row(a);
    const std::span<const Partner> next = now.row(a);
    std::size_t i = 0;
    std::size_t k = 0;
    while (i < old.size() && k < next.size()) {
      if (old[i] == next[k]) {
        ++i;
        ++k;
      } else if (old[i] < next[k]) {
        lost(a, old[i++]);
      } else {
        gained(a, next[k++]);
      }
    }
    while (i < old.size()) lost(a, old[i++]);
    while (k < next.size()) gained(a, next[k++]);
  }
}

}  // namespace kerf
