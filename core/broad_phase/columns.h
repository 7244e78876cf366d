#pragma once

#include <array>
#include <vector>

#include "core/broad_phase/axis_cells.h"
#include "core/broad_phase/tabled.h"
#include "core/kernels/lanes.h"
#include "core/kernels/radix_sort.h"
#include "core/objects/structure.h"

namespace kerf {

/// A grid of columns, built anew in each step: cells across all axes but the one along which the scene is
/// longest. Objects are sorted along that axis by radix, put into every column that they reach, and each
/// column is swept, a vector of boxes at a time.
///
/// Two boxes that overlap share a column. The pair is reported by the column in which, along each axis, at
/// least one of both begins. There is only one: where the later beginning lies.
template <int D>
class Columns final : public Tabled<D>, public SelfDescribing<D> {
 public:
  [[nodiscard]] std::string_view name() const override { return "columns"; }
  /// The columns, and the order along them. Vectors also test a few boxes beyond the last that begins early
  /// enough; those are left out.
  void describe(StructureParts<D>& parts) const override;

 private:
  static constexpr std::size_t kAcross = D - 1;
  /// The cells that an object reaches across the columns.
  struct Reach {
    std::array<std::uint16_t, kAcross> first;
    std::array<std::uint16_t, kAcross> last;
  };
  /// An object in a column. `axis` 0 is the one along the column.
  struct Entry {
    std::array<Scalar, D> min;
    std::array<Scalar, D> max;
    std::uint32_t object;
    std::uint32_t apart;
  };
  struct Grid {
    std::array<int, D> axes{};  ///< of the world: the one along the columns, then those across
    std::array<AxisCells, kAcross> across;
  };

  void find_pairs(PairList& pairs) override;
  void measure();
  void lay_out(double size);
  [[nodiscard]] Reach reach_of(const Box<D>& box) const;
  std::size_t count_entries();
  void sort_objects();
  void deal();
  void sweep(PairList& pairs);
  [[nodiscard]] Box<D> column_box(std::size_t column) const;
  void tell_column(std::size_t column, StructureParts<D>& parts) const;
  template <class Visit>
  void for_each_column(const Reach& reach, Visit visit) const;

  Grid grid_;
  std::array<double, D> low_{};      ///< least beginning of the boxes
  std::array<double, D> high_{};     ///< greatest end of the boxes
  std::array<double, D> extent_{};   ///< mean extent of a box
  std::vector<Reach> reaches_;       ///< by object
  std::vector<std::uint32_t> ends_;  ///< by column: one past its last entry so far
  RadixSort order_;
  std::vector<Entry> entries_;
  Lanes<D> lanes_;
};

}  // namespace kerf
