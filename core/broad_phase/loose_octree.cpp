#include "core/broad_phase/loose_octree.h"

#include <algorithm>
#include <utility>

namespace kerf {

/// So many levels that the finest one has about two cells an object.
template <int D>
void LooseOctree<D>::lay_out() {
  finest_ = 0;
  while (std::size_t{1} << (D * (finest_ + 1)) <= 2 * this->placed().size()) ++finest_;
  level_begins_.assign(1, 0);
  for (unsigned level = 0; level <= finest_; ++level)
    level_begins_.push_back(level_begins_.back() + (1U << (D * level)));
  Box<D> begins = Box<D>::empty();
  for (const ObjectId object : this->placed()) {
    const Box<D>& box = this->table().box(object);
    for (int i = 0; i < D; ++i) {
      begins.min[i] = std::min(begins.min[i], box.min[i]);
      begins.max[i] = std::max(begins.max[i], box.min[i]);
    }
  }
  for (std::size_t i = 0; i < D; ++i)
    axes_[i] = AxisCells(begins.min[static_cast<int>(i)], begins.max[static_cast<int>(i)], 1U << finest_);
}

template <int D>
typename LooseOctree<D>::Member LooseOctree<D>::member_of(ObjectId object) const {
  Member member{this->table().box(object), object, this->table().is_fixed(object), 0, {}, {}};
  unsigned up = 0;
  for (std::size_t i = 0; i < D; ++i) {
    member.first[i] = axes_[i].cell(member.box.min[static_cast<int>(i)]);
    member.last[i] = axes_[i].cell(member.box.max[static_cast<int>(i)]);
    while ((member.last[i] >> up) - (member.first[i] >> up) > 1) ++up;
  }
  // What fits at one level fits at all coarser ones.
  member.level = static_cast<std::uint8_t>(finest_ - up);
  return member;
}

template <int D>
std::uint32_t LooseOctree<D>::cell_of(unsigned level, const Place& place) const {
  std::uint32_t number = 0;
  for (std::size_t i = D; i-- > 0;) number = (number << level) + place[i];
  return level_begins_[level] + number;
}

/// By counting the members of each cell.
template <int D>
void LooseOctree<D>::sort_members() {
  unsorted_.clear();
  cells_.clear();
  ends_.assign(level_begins_.back(), 0);
  level_members_.assign(finest_ + 1, 0);
  for (const ObjectId object : this->placed()) {
    unsorted_.push_back(member_of(object));
    const Member& member = unsorted_.back();
    Place place = member.first;
    for (std::uint32_t& x : place) x >>= finest_ - member.level;
    cells_.push_back(cell_of(member.level, place));
    ++ends_[cells_.back()];
    ++level_members_[member.level];
  }
  std::uint32_t end = 0;
  for (std::uint32_t& place : ends_) end += std::exchange(place, end);
  members_.resize(unsorted_.size());
  for (std::size_t k = 0; k < unsorted_.size(); ++k) members_[ends_[cells_[k]]++] = unsorted_[k];
}

/// Without a branch, since hits can hardly be predicted.
template <int D>
void LooseOctree<D>::test_row(const Member& member, std::uint32_t begin, std::uint32_t end, PairList& pairs) {
  candidates_ += end - begin;
  Pair* out = pairs.reserve(end - begin);
  for (std::uint32_t k = begin; k < end; ++k) {
    const Member& other = members_[k];
    *out = make_pair(member.object, other.object);
    out += (overlaps(member.box, other.box) & !(member.fixed & other.fixed)) ? 1 : 0;
  }
  pairs.commit(out);
}

template <int D>
template <class Visit>
void LooseOctree<D>::for_each_row(std::uint32_t index, unsigned level, Visit visit) const {
  const Member& member = members_[index];
  const std::uint32_t from = level == member.level ? index + 1 : 0;
  Place first;
  Place last;
  for (std::size_t i = 0; i < D; ++i) {
    const std::uint32_t begin = member.first[i] >> (finest_ - level);
    first[i] = begin - (begin > 0 ? 1 : 0);
    last[i] = member.last[i] >> (finest_ - level);
  }
  Place place = first;
  const std::uint32_t row = last[0] - first[0];
  for (std::uint32_t z = D == 3 ? first[D - 1] : 0; z <= (D == 3 ? last[D - 1] : 0); ++z) {
    if (D == 3) place[D - 1] = z;
    for (place[1] = first[1]; place[1] <= last[1]; ++place[1]) {
      const std::uint32_t cell = cell_of(level, place);
      const std::uint32_t begin = std::max(cell == 0 ? 0 : ends_[cell - 1], from);
      if (begin < ends_[cell + row]) visit(begin, ends_[cell + row]);
    }
  }
}

template <int D>
template <class Visit>
void LooseOctree<D>::for_each_row(std::uint32_t index, Visit visit) const {
  for (unsigned level = 0; level <= members_[index].level; ++level)
    if (level_members_[level] != 0) for_each_row(index, level, visit);
}

template <int D>
void LooseOctree<D>::arrange() {
  members_.clear();
  if (this->placed().empty()) return;
  lay_out();
  sort_members();
}

template <int D>
void LooseOctree<D>::find_pairs(PairList& pairs) {
  candidates_ = 0;
  for (std::uint32_t k = 0; k < members_.size(); ++k)
    for_each_row(k,
                 [&](std::uint32_t begin, std::uint32_t end) { test_row(members_[k], begin, end, pairs); });
}

/// Where members of a cell begin, and the next place, into which they may reach.
template <int D>
Box<D> LooseOctree<D>::loose_box(unsigned level, const Place& place) const {
  const unsigned up = finest_ - level;
  Box<D> box;
  for (std::size_t i = 0; i < D; ++i) {
    const auto axis = static_cast<int>(i);
    box.min[axis] = axes_[i].begin(place[i] << up);
    box.max[axis] = axes_[i].begin((place[i] + 2) << up);
  }
  return box;
}

template <int D>
void LooseOctree<D>::tell_cells(StructureParts<D>& parts) const {
  constexpr std::uint32_t kUnused = kNoPart;
  std::vector<std::uint32_t> part_of(level_begins_.back(), kUnused);
  const auto tell = [&](auto&& self, unsigned level, const Place& place) -> std::uint32_t {
    const std::uint32_t cell = cell_of(level, place);
    if (part_of[cell] != kUnused) return part_of[cell];
    Place above = place;
    for (std::uint32_t& x : above) x >>= 1U;
    const std::uint32_t parent = level == 0 ? kNoPart : self(self, level - 1, above);
    part_of[cell] = static_cast<std::uint32_t>(parts.cells.size());
    parts.cells.push_back({loose_box(level, place), cell, parent, level, kNoPart});
    return part_of[cell];
  };
  for (const Member& member : members_) {
    Place place = member.first;
    for (std::uint32_t& x : place) x >>= finest_ - member.level;
    parts.members.push_back({tell(tell, member.level, place), member.object});
  }
}

template <int D>
void LooseOctree<D>::describe(StructureParts<D>& parts) const {
  parts.kind = "levels of loose cells";
  if (!members_.empty()) tell_cells(parts);
  for (std::uint32_t k = 0; k < members_.size(); ++k)
    for_each_row(k, [&](std::uint32_t begin, std::uint32_t end) {
      for (std::uint32_t i = begin; i < end; ++i) parts.tell_tested(members_[k].object, members_[i].object);
    });
  parts.end_tested();
  parts.bytes = bytes_of(level_begins_) + bytes_of(level_members_) + bytes_of(ends_) + bytes_of(cells_) +
                bytes_of(unsorted_) + bytes_of(members_);
}

template class LooseOctree<2>;
template class LooseOctree<3>;

}  // namespace kerf
