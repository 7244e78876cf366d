#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "core/broad_phase/tabled.h"
#include "core/objects/structure.h"

namespace kerf {

/// Spatial hash tables of several cell sizes: B. Mirtich, "Efficient algorithms for two-phase collision
/// detection" (MERL TR-97-23, 1997).
///
/// Read for boxes: an object is stored at the level whose cells are just as large as it is, in each cell that
/// it reaches into, and looks for others in the cells of its own level and of all coarser ones that are in
/// use. Cells are powers of two, 2^22 of them at most along an axis of the scene. A pair is found in the cell
/// in which the overlap begins, and so once.
template <int D>
class MultiLevelHash final : public Tabled<D>, public SelfDescribing<D> {
 public:
  [[nodiscard]] std::string_view name() const override { return "multi-level-hash"; }
  /// Pairs of boxes that the last `step()` compared.
  [[nodiscard]] std::uint64_t candidates() const { return candidates_; }
  /// Levels in use.
  [[nodiscard]] std::size_t levels() const { return levels_.size(); }
  /// The cells that hold objects; the coarsest level has depth 0.
  void describe(StructureParts<D>& parts) const override;

 private:
  struct Cell {
    int level = 0;  ///< its size is 2^level
    std::array<std::int32_t, D> place{};
    friend bool operator==(const Cell&, const Cell&) = default;
  };
  struct HashCell {
    std::size_t operator()(const Cell& cell) const;
  };

  void arrange() override;
  void find_pairs(PairList& pairs) override;
  [[nodiscard]] int level_of(const Box<D>& box) const;
  [[nodiscard]] static Cell cell_at(int level, const Vector<D>& point);
  template <class Visit>
  static void for_each_cell(int level, const Box<D>& box, const Visit& visit);
  [[nodiscard]] static Box<D> box_of(const Cell& cell);
  /// Calls `visit(object, other, cell)` for each two whose boxes are compared in a cell.
  template <class Visit>
  void for_each_test(const Visit& visit) const;
  template <class Visit>
  void for_each_test(ObjectId object, const Cell& cell, const Visit& visit) const;

  int finest_ = 0;
  std::vector<int> levels_;        ///< in use, the finest first
  std::vector<int> object_level_;  ///< by object
  std::unordered_map<Cell, std::vector<ObjectId>, HashCell> cells_;
  std::uint64_t candidates_ = 0;
};

}  // namespace kerf
