#pragma once

#include "core/broad_phase/radix_sort.h"
#include "core/broad_phase/tabled.h"
#include "core/kernels/lanes.h"

namespace kerf {

/// Sort-and-sweep: boxes in the order of their beginning along the axis on which their centres are spread
/// most, each tested against those that begin before it ends, a vector of them at a time.
template <int D>
class SortAndSweep final : public Tabled<D> {
 public:
  [[nodiscard]] std::string_view name() const override { return "sort-and-sweep"; }

 private:
  void find_pairs(PairList& pairs) override;
  [[nodiscard]] int widest_axis() const;

  RadixSort order_;
  Lanes<D> lanes_;
};

extern template class SortAndSweep<2>;
extern template class SortAndSweep<3>;

}  // namespace kerf
