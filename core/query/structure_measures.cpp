#include "core/query/structure_measures.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kerf {
namespace {

template <int D>
Box<D> common_part(const Box<D>& a, const Box<D>& b) {
  Box<D> box;
  for (int i = 0; i < D; ++i) {
    box.min[i] = std::max(a.min[i], b.min[i]);
    box.max[i] = std::min(a.max[i], b.max[i]);
  }
  return box;
}

/// 0 of a box that is none.
template <int D>
double volume(const Box<D>& box) {
  double volume = 1;
  for (int i = 0; i < D; ++i) volume *= std::max(0.0, double{box.max[i]} - double{box.min[i]});
  return volume;
}

template <int D>
class Measurer {
 public:
  Measurer(const StructureParts<D>& parts, std::span<const Box<D>> boxes, const Box<D>& bounds)
      : parts_(parts), bounds_(bounds), children_(children_of(parts)), contents_(parts.cells.size()) {
    for (const CellMember& member : parts.members)
      if (member.object.index() < boxes.size())
        contents_[member.cell].push_back(boxes[member.object.index()]);
    for (const StructureCell<D>& cell : parts.cells)
      if (cell.parent != kNoPart && cell.cut == kNoPart) contents_[cell.parent].push_back(cell.box);
  }

  /// The mean over cells that hold anything.
  [[nodiscard]] double dead() const {
    double sum = 0;
    std::uint32_t count = 0;
    for (std::uint32_t cell = 0; cell < contents_.size(); ++cell) {
      if (contents_[cell].empty()) continue;
      const double share = dead_share(cell);
      if (share < 0) continue;
      sum += share;
      ++count;
    }
    return count == 0 ? 0 : sum / count;
  }

  [[nodiscard]] double overlap(bool& has_parents) const {
    double sum = 0;
    std::uint32_t count = 0;
    for (const std::vector<std::uint32_t>& children : children_) {
      if (children.size() < 2) continue;
      ++count;
      double share = 0;
      for (std::size_t i = 0; i < children.size(); ++i)
        for (std::size_t k = i + 1; k < children.size(); ++k)
          share += overlap_share(parts_, children[i], children[k], bounds_);
      sum += std::min(1.0, share);
    }
    has_parents = count > 0;
    return count == 0 ? 0 : sum / count;
  }

 private:
  /// Exact for one box inside; otherwise of the points of a lattice. Negative: the cell has no volume.
  [[nodiscard]] double dead_share(std::uint32_t cell) const {
    const Box<D> box = with_ends(parts_.cells[cell].box, bounds_);
    const double whole = volume(box);
    if (!(whole > 0)) return -1;
    const std::vector<Box<D>>& inside = contents_[cell];
    if (inside.size() == 1 && parts_.cells[cell].cut == kNoPart)
      return 1 - volume(common_part(box, inside.front())) / whole;
    constexpr std::uint32_t kSteps = D == 2 ? 16 : 6;
    std::uint32_t points = 0;
    std::uint32_t dead = 0;
    for (std::uint32_t place = 0; place < (D == 2 ? kSteps * kSteps : kSteps * kSteps * kSteps); ++place) {
      Vector<D> point;
      std::uint32_t rest = place;
      for (int i = 0; i < D; ++i, rest /= kSteps) {
        const double t = (rest % kSteps + 0.5) / kSteps;
        point[i] = static_cast<Scalar>(box.min[i] + (double{box.max[i]} - box.min[i]) * t);
      }
      if (!is_in_cell(cell, point)) continue;
      ++points;
      const Box<D> spot{point, point};
      dead +=
          std::ranges::none_of(inside, [&](const Box<D>& part) { return contains(part, spot); }) ? 1U : 0U;
    }
    return points == 0 ? -1 : double{1} * dead / points;
  }

  [[nodiscard]] bool is_in_cell(std::uint32_t cell, const Vector<D>& point) const {
    for (; cell != kNoPart; cell = parts_.cells[cell].parent) {
      if (parts_.cells[cell].cut == kNoPart) continue;
      const Cut<D>& cut = parts_.cuts[parts_.cells[cell].cut];
      if ((dot(cut.plane.normal, point) > cut.plane.offset) != cut.right) return false;
    }
    return true;
  }

  const StructureParts<D>& parts_;
  const Box<D>& bounds_;
  std::vector<std::vector<std::uint32_t>> children_;
  std::vector<std::vector<Box<D>>> contents_;  ///< by cell: the boxes of what it holds
};

}  // namespace

template <int D>
std::vector<std::vector<std::uint32_t>> children_of(const StructureParts<D>& parts) {
  std::vector<std::vector<std::uint32_t>> children(parts.cells.size());
  for (std::uint32_t cell = 0; cell < parts.cells.size(); ++cell)
    if (parts.cells[cell].parent != kNoPart) children[parts.cells[cell].parent].push_back(cell);
  return children;
}

template <int D>
Box<D> with_ends(Box<D> box, const Box<D>& bounds) {
  for (int i = 0; i < D; ++i) {
    if (!std::isfinite(box.min[i])) box.min[i] = std::min(bounds.min[i], box.max[i]);
    if (!std::isfinite(box.max[i])) box.max[i] = std::max(bounds.max[i], box.min[i]);
  }
  return box;
}

template <int D>
double overlap_share(const StructureParts<D>& parts, std::uint32_t a, std::uint32_t b, const Box<D>& bounds) {
  const StructureCell<D>& first = parts.cells[a];
  if (first.cut != kNoPart || first.parent == kNoPart) return 0;
  const Box<D> parent = with_ends(parts.cells[first.parent].box, bounds);
  const Box<D> shared = common_part(with_ends(first.box, bounds), with_ends(parts.cells[b].box, bounds));
  double whole = 0;  // of the axes along which the parent is not flat
  double common = 0;
  for (int i = 0; i < D; ++i) {
    const double length = double{parent.max[i]} - double{parent.min[i]};
    if (length < 0) return 0;
    if (length == 0) continue;
    common = (whole > 0 ? common : 1) * std::max(0.0, double{shared.max[i]} - double{shared.min[i]});
    whole = (whole > 0 ? whole : 1) * length;
  }
  // A parent without ends has no share.
  return whole > 0 && whole < std::numeric_limits<double>::infinity() ? common / whole : 0;
}

template <int D>
StructureMeasures measure(const StructureParts<D>& parts, std::span<const Box<D>> boxes,
                          const Box<D>& bounds) {
  StructureMeasures measures;
  measures.cells = static_cast<std::uint32_t>(parts.cells.size());
  measures.members = parts.members.size();
  for (const StructureCell<D>& cell : parts.cells) measures.depth = std::max(measures.depth, cell.depth);
  const Measurer<D> measurer(parts, boxes, bounds);
  measures.overlap = measurer.overlap(measures.has_parents);
  measures.dead = measurer.dead();
  return measures;
}

#define KERF_INSTANTIATE(D)                                                                             \
  template std::vector<std::vector<std::uint32_t>> children_of(const StructureParts<D>&);               \
  template Box<D> with_ends(Box<D>, const Box<D>&);                                                     \
  template double overlap_share(const StructureParts<D>&, std::uint32_t, std::uint32_t, const Box<D>&); \
  template StructureMeasures measure(const StructureParts<D>&, std::span<const Box<D>>, const Box<D>&);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
