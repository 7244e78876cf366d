#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/broad_phase/axis_cells.h"
#include "core/broad_phase/tabled.h"
#include "core/objects/structure.h"

namespace kerf {

/// A loose octree (in 2D a quadtree) after Thatcher Ulrich ("Loose Octrees", Game Programming Gems, 2000),
/// built anew in each step. A cell holds the objects that begin in its place and reach no farther than into
/// the next place, so that each object is in exactly one cell, found without a search: that of the finest
/// level where this holds. Levels are flat grids and cells are ranges of one array, without pointers. An
/// object is tested against those behind it in its own level and against all in coarser ones.
///
/// Places are whole numbers, computed once at the finest level and halved for coarser ones. Rounding is
/// monotone, so no overlap is lost.
template <int D>
class LooseOctree final : public Tabled<D>, public SelfDescribing<D> {
 public:
  [[nodiscard]] std::string_view name() const override { return "loose-octree"; }
  /// How many pairs of boxes the last `step()` tested.
  [[nodiscard]] std::uint64_t candidates() const { return candidates_; }
  /// Cells that hold objects, and those around them. The box of a cell is what its members may reach, so that
  /// neighbours overlap.
  void describe(StructureParts<D>& parts) const override;

 private:
  using Place = std::array<std::uint32_t, D>;
  struct Member {
    Box<D> box;
    ObjectId object;
    bool fixed = false;
    std::uint8_t level = 0;
    Place first;  ///< at the finest level, where the object begins
    Place last;   ///< and ends
  };

  void arrange() override;
  void find_pairs(PairList& pairs) override;
  void lay_out();
  [[nodiscard]] Member member_of(ObjectId object) const;
  /// The number of a cell; `place` is that of its level. Level 0 is one cell.
  [[nodiscard]] std::uint32_t cell_of(unsigned level, const Place& place) const;
  void sort_members();
  [[nodiscard]] Box<D> loose_box(unsigned level, const Place& place) const;
  void tell_cells(StructureParts<D>& parts) const;
  /// Calls `visit(begin, end)` for each row of members with which a member is tested.
  template <class Visit>
  void for_each_row(std::uint32_t index, Visit visit) const;
  template <class Visit>
  void for_each_row(std::uint32_t index, unsigned level, Visit visit) const;
  void test_row(const Member& member, std::uint32_t begin, std::uint32_t end, PairList& pairs);

  unsigned finest_ = 0;
  std::array<AxisCells, D> axes_;             ///< of the finest level
  std::vector<std::uint32_t> level_begins_;   ///< by level: its first cell; one more at the end
  std::vector<std::uint32_t> level_members_;  ///< by level
  std::vector<std::uint32_t> ends_;           ///< by cell: one past its last member
  std::vector<std::uint32_t> cells_;          ///< by place in `unsorted_`
  std::vector<Member> unsorted_;
  std::vector<Member> members_;  ///< by cell
  std::uint64_t candidates_ = 0;
};

}  // namespace kerf
