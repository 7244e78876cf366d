#include "core/broad_phase/sweep_and_prune.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace kerf {

template <int D>
SweepAndPrune<D>::SweepAndPrune(const AxisChoice& axes) {
  for (int axis = 0; axis < D; ++axis)
    if (axes[static_cast<std::size_t>(axis)]) lists_.push_back({axis, {}});
  if (lists_.empty()) throw std::invalid_argument("sweep-and-prune needs at least one axis");
}

template <int D>
typename SweepAndPrune<D>::Part SweepAndPrune<D>::part_of(ObjectId object) const {
  if (!this->table().is_placed(object)) return Part::none;
  return this->table().is_fixed(object) ? Part::listed_fixed : Part::listed;
}

template <int D>
bool SweepAndPrune<D>::is_candidate(ObjectId a, ObjectId b) const {
  const Box<D> box = this->table().box(a);
  const Box<D> other = this->table().box(b);
  bool all = !(this->table().is_fixed(a) && this->table().is_fixed(b));
  for (const List& list : lists_)
    all &= (box.min[list.axis] <= other.max[list.axis]) & (other.min[list.axis] <= box.max[list.axis]);
  return all;
}

template <int D>
void SweepAndPrune<D>::arrange() {
  drop_gone();
  for (List& list : lists_) {
    renew(list);
    swap_into_order(list);
  }
  list_new();
}

/// Also drops an object whose mobility changed: a fixed object that came back as a moving one.
template <int D>
void SweepAndPrune<D>::drop_gone() {
  parts_.resize(this->table().bound(), Part::none);
  std::vector<std::uint8_t> gone(parts_.size(), 0);
  bool any = false;
  for (std::uint32_t id = 0; id < parts_.size(); ++id) {
    if (parts_[id] == Part::none || parts_[id] == part_of({id})) continue;
    parts_[id] = Part::none;
    gone[id] = 1;
    any = true;
  }
  if (!any) return;
  for (List& list : lists_) std::erase_if(list.ends, [&](const End& end) { return gone[end.object] != 0; });
  candidates_.remove_if([&](const Pair& p) { return gone[p.a.index()] != 0 || gone[p.b.index()] != 0; });
}

template <int D>
void SweepAndPrune<D>::renew(List& list) const {
  for (End& end : list.ends) {
    const Box<D> box = this->table().box({end.object});
    end.value = end.upper ? box.max[list.axis] : box.min[list.axis];
  }
}

/// Insertion sort: linear in a list that is nearly in order.
template <int D>
void SweepAndPrune<D>::swap_into_order(List& list) {
  for (std::size_t k = 1; k < list.ends.size(); ++k) {
    const End end = list.ends[k];
    std::size_t place = k;
    for (; place > 0 && end < list.ends[place - 1]; --place) {
      meet(end, list.ends[place - 1]);
      list.ends[place] = list.ends[place - 1];
    }
    list.ends[place] = end;
  }
}

/// `coming` goes below `passed`. All boxes are those of this step already, so a new overlap is seen at the
/// swap on any axis along which there was none before.
template <int D>
void SweepAndPrune<D>::meet(const End& coming, const End& passed) {
  if (coming.upper == passed.upper) return;
  const Pair pair = make_pair({coming.object}, {passed.object});
  if (coming.upper) {
    candidates_.remove(pair);
  } else if (is_candidate(pair.a, pair.b)) {
    candidates_.add(pair);
  }
}

/// New objects are merged in, because swaps would carry each through half the list.
template <int D>
void SweepAndPrune<D>::list_new() {
  new_.clear();
  for (const ObjectId object : this->placed())
    if (parts_[object.index()] == Part::none) new_.push_back(object);
  if (new_.empty()) return;
  for (const ObjectId object : new_) parts_[object.index()] = part_of(object);
  for (List& list : lists_) {
    const auto old = static_cast<std::ptrdiff_t>(list.ends.size());
    for (const ObjectId object : new_) {
      const Box<D> box = this->table().box(object);
      list.ends.push_back({box.min[list.axis], object.value, false});
      list.ends.push_back({box.max[list.axis], object.value, true});
    }
    std::sort(list.ends.begin() + old, list.ends.end());
    std::inplace_merge(list.ends.begin(), list.ends.begin() + old, list.ends.end());
  }
  find_pairs_of_new();
}

/// A walk along the first list: a new object meets all open ones, an old one only the new ones.
template <int D>
void SweepAndPrune<D>::find_pairs_of_new() {
  is_new_.assign(parts_.size(), 0);
  for (const ObjectId object : new_) is_new_[object.index()] = 1;
  std::vector<ObjectId> open;
  std::vector<ObjectId> open_new;
  for (const End& end : lists_.front().ends) {
    const ObjectId object{end.object};
    std::vector<ObjectId>& own = is_new_[end.object] != 0 ? open_new : open;
    if (end.upper) {
      own.erase(std::find(own.begin(), own.end(), object));
      continue;
    }
    const auto admit = [&](ObjectId other) {
      if (is_candidate(object, other)) candidates_.add(make_pair(object, other));
    };
    std::for_each(open_new.begin(), open_new.end(), admit);
    if (is_new_[end.object] != 0) std::for_each(open.begin(), open.end(), admit);
    own.push_back(object);
  }
}

template <int D>
void SweepAndPrune<D>::find_pairs(PairList& pairs) {
  for (const Pair& pair : candidates_.pairs())
    if (this->table().is_pair(pair.a, pair.b)) pairs.add(pair);
}

template <int D>
void SweepAndPrune<D>::describe(StructureParts<D>& parts) const {
  constexpr std::uint64_t kBytesOfPair = 48;  // in the list, and in the set with its links
  parts.kind = "lists along axes";
  parts.bytes = kBytesOfPair * candidates_.pairs().size() + bytes_of(parts_);
  for (const List& list : lists_) {
    AxisList told{list.axis, {}};
    for (const End& end : list.ends) told.ends.push_back({end.value, {end.object}, end.upper});
    parts.lists.push_back(std::move(told));
    *parts.bytes += bytes_of(list.ends);
  }
  parts.tested.assign(candidates_.pairs().begin(), candidates_.pairs().end());
  parts.end_tested();
}

template class SweepAndPrune<2>;
template class SweepAndPrune<3>;

}  // namespace kerf
