#include "core/related/multi_level_hash.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kerf {
namespace {

constexpr int kMostBits = 22;  ///< of a cell's number along an axis, its sign not counted
constexpr int kFinest = -120;  ///< a finer level would need denormal numbers

/// The least level whose cells are at least so large.
int level_for(double size) {
  int exponent = 0;
  const double part = std::frexp(size, &exponent);
  return part == 0.5 ? exponent - 1 : exponent;
}

}  // namespace

template <int D>
std::size_t MultiLevelHash<D>::HashCell::operator()(const Cell& cell) const {
  std::uint64_t hash = static_cast<std::uint64_t>(cell.level + 1024);
  for (const std::int32_t x : cell.place) {
    hash = (hash ^ static_cast<std::uint32_t>(x)) * 0x9e3779b97f4a7c15U;
    hash ^= hash >> 29U;
  }
  return hash;
}

template <int D>
typename MultiLevelHash<D>::Cell MultiLevelHash<D>::cell_at(int level, const Vector<D>& point) {
  Cell cell{level, {}};
  for (int i = 0; i < D; ++i)
    cell.place[static_cast<std::size_t>(i)] =
        static_cast<std::int32_t>(std::floor(std::ldexp(double{point[i]}, -level)));
  return cell;
}

template <int D>
template <class Visit>
void MultiLevelHash<D>::for_each_cell(int level, const Box<D>& box, const Visit& visit) {
  const Cell first = cell_at(level, box.min);
  const Cell last = cell_at(level, box.max);
  Cell cell = first;
  for (;;) {
    visit(cell);
    std::size_t axis = 0;
    while (axis < D && cell.place[axis] == last.place[axis]) {
      cell.place[axis] = first.place[axis];
      ++axis;
    }
    if (axis == D) return;
    ++cell.place[axis];
  }
}

template <int D>
int MultiLevelHash<D>::level_of(const Box<D>& box) const {
  double size = 0;
  for (int i = 0; i < D; ++i) size = std::max(size, double{box.max[i]} - double{box.min[i]});
  return size > 0 ? std::max(finest_, level_for(size)) : finest_;
}

template <int D>
void MultiLevelHash<D>::arrange() {
  cells_.clear();
  levels_.clear();
  object_level_.assign(this->table().bound(), 0);
  double reach = 0;
  for (const ObjectId object : this->placed()) {
    const Box<D> box = this->table().box(object);
    for (int i = 0; i < D; ++i)
      reach = std::max({reach, std::abs(double{box.min[i]}), std::abs(double{box.max[i]})});
  }
  finest_ = reach > 0 ? std::max(kFinest, level_for(reach) - kMostBits) : 0;
  for (const ObjectId object : this->placed()) {
    const Box<D> box = this->table().box(object);
    const int level = level_of(box);
    object_level_[object.index()] = level;
    levels_.push_back(level);
    for_each_cell(level, box, [&](const Cell& cell) { cells_[cell].push_back(object); });
  }
  std::ranges::sort(levels_);
  levels_.erase(std::unique(levels_.begin(), levels_.end()), levels_.end());
}

template <int D>
template <class Visit>
void MultiLevelHash<D>::for_each_test(ObjectId object, const Cell& cell, const Visit& visit) const {
  const auto found = cells_.find(cell);
  if (found == cells_.end()) return;
  const bool is_own_level = cell.level == object_level_[object.index()];
  for (const ObjectId other : found->second)
    if (!is_own_level || object < other) visit(object, other, cell);
}

template <int D>
template <class Visit>
void MultiLevelHash<D>::for_each_test(const Visit& visit) const {
  for (const ObjectId object : this->placed()) {
    const auto first = std::ranges::lower_bound(levels_, object_level_[object.index()]);
    for (auto level = first; level != levels_.end(); ++level)
      for_each_cell(*level, this->table().box(object),
                    [&](const Cell& cell) { for_each_test(object, cell, visit); });
  }
}

template <int D>
void MultiLevelHash<D>::find_pairs(PairList& pairs) {
  candidates_ = 0;
  for_each_test([&](ObjectId object, ObjectId other, const Cell& cell) {
    ++candidates_;
    const Box<D>& box = this->table().box(object);
    const Box<D>& theirs = this->table().box(other);
    if (!overlaps(box, theirs) || (this->table().is_fixed(object) && this->table().is_fixed(other))) return;
    Vector<D> begin;
    for (int i = 0; i < D; ++i) begin[i] = std::max(box.min[i], theirs.min[i]);
    if (cell_at(cell.level, begin) == cell) pairs.add(make_pair(object, other));
  });
}

template <int D>
Box<D> MultiLevelHash<D>::box_of(const Cell& cell) {
  Box<D> box;
  for (int i = 0; i < D; ++i) {
    const double place = cell.place[static_cast<std::size_t>(i)];
    box.min[i] = static_cast<Scalar>(std::ldexp(place, cell.level));
    box.max[i] = static_cast<Scalar>(std::ldexp(place + 1, cell.level));
  }
  return box;
}

template <int D>
void MultiLevelHash<D>::describe(StructureParts<D>& parts) const {
  parts.kind = "cells of several sizes";
  parts.holding = Holding::of_its_depth;
  std::vector<const std::pair<const Cell, std::vector<ObjectId>>*> cells;
  for (const auto& entry : cells_) cells.push_back(&entry);
  std::ranges::sort(cells, [](const auto* a, const auto* b) {
    return std::pair(-a->first.level, a->first.place) < std::pair(-b->first.level, b->first.place);
  });
  parts.bytes = bytes_of(levels_) + bytes_of(object_level_);
  for (const auto* entry : cells) {
    const auto& [cell, objects] = *entry;
    const auto index = static_cast<std::uint32_t>(parts.cells.size());
    const auto depth = static_cast<std::uint32_t>(levels_.end() - std::ranges::find(levels_, cell.level)) - 1;
    parts.cells.push_back({box_of(cell), index, kNoPart, depth, kNoPart});
    for (const ObjectId object : objects) parts.members.push_back({index, object});
    *parts.bytes += sizeof(*entry) + bytes_of(objects);
  }
  for_each_test(
      [&](ObjectId object, ObjectId other, const Cell& /*cell*/) { parts.tell_tested(object, other); });
  parts.end_tested();
}

template class MultiLevelHash<2>;
template class MultiLevelHash<3>;

}  // namespace kerf
