#pragma once

#include "core/broad_phase/tabled.h"
#include "core/kernels/lanes.h"
#include "core/kernels/radix_sort.h"
#include "core/objects/structure.h"

namespace kerf {

/// Sort-and-sweep: boxes in the order of their beginning along the axis on which their centres are spread
/// most, each tested against those that begin before it ends, a vector of them at a time.
template <int D>
class SortAndSweep final : public Tabled<D>, public SelfDescribing<D> {
 public:
  [[nodiscard]] std::string_view name() const override { return "sort-and-sweep"; }
  /// The order along the axis. Vectors also test a few boxes beyond the last that begins early enough; those
  /// are left out.
  void describe(StructureParts<D>& parts) const override;

 private:
  void find_pairs(PairList& pairs) override;
  [[nodiscard]] int widest_axis() const;

  int axis_ = 0;
  RadixSort order_;
  Lanes<D> lanes_;
};

}  // namespace kerf
