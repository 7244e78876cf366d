// How the tree's entries follow the objects.

#include <algorithm>
#include <utility>

#include "core/bsp/bsp.h"
#include "core/kernels/prefetch.h"
#include "core/tree/placement.h"

namespace kerf {

/// Brings the entries up to date with the objects. Placement is never deferred: it is what makes the pairs
/// complete.
template <int D, class Trace>
void Bsp<D, Trace>::place() {
  exchange_.end(latest_, tree_.table, {}, *pool_);
  const Mode before = mode_;
  choose_mode();
  leaf_boxes_.begin(tree_, false);
  if (mode_ == Mode::kept && before == Mode::kept) {
    slim_some();
    follow_restless();
  }
  const auto more_than = [this](float share) {
    return static_cast<float>(changed_.size()) > share * static_cast<float>(latest_.size());
  };
  if (mode_ == Mode::kept) {
    if (before != Mode::kept) {
      fatten_all();
    } else if (more_than(4 * config_.stream_share)) {
      // Four times, since kept leaves must then be swept anew, which they need not be for a patch.
      make_fat_boxes();
      take_fat_boxes();
      place_all();
    } else {
      place_fat();
    }
  } else if (before == Mode::kept || (mode_ == Mode::swept && more_than(config_.stream_share))) {
    const bool many_stay = only_moves_ && !most_jump();
    if (only_moves_ && before == Mode::swept) {
      exchange_.begin(latest_, tree_.table);
    } else {
      tree_.table.copy_all(latest_, *pool_);
    }
    place_all(many_stay);
  } else {
    place_changes();
  }
  put_at_rest();
  exchange_.take(changed_);
  before_.clear();
  only_moves_ = true;
}

/// Takes note that nothing is left to do for those who changed.
template <int D, class Trace>
void Bsp<D, Trace>::put_at_rest() {
  const bool all_alike = only_moves_ && mode_ != Mode::kept;
  if (all_alike && changed_.size() == attention_.size()) {
    std::ranges::fill(attention_, std::uint8_t{0});
    return;
  }
  pool_->for_slices(changed_.size(), [this, all_alike](const Slice& slice, std::size_t) {
    std::uint8_t* const attention = attention_.data();  // what is written through it could be this very tree
    const auto objects = std::as_const(changed_).all().subspan(slice.begin, slice.end - slice.begin);
    if (all_alike) {
      for (const ObjectId object : objects) attention[object.index()] = 0;
    } else {
      for (const ObjectId object : objects) attention[object.index()] = attention_at_rest(object);
    }
  });
}

/// `many_stay`: nobody came or went, and it pays to see first who still lies wholly in its leaf's cell.
template <int D, class Trace>
void Bsp<D, Trace>::place_all(bool many_stay) {
  placed_ = changed_.size();
  leaf_boxes_.begin(tree_, mode_ == Mode::swept && exceeds(std::as_const(tree_.table).packed(), kOwnPages));
  if (many_stay) {
    leave_pass_.run(tree_, *pool_, leaf_boxes_);
    stream(tree_, leave_pass_, leaf_boxes_, stream_memory_, *pool_);
  } else {
    stream(tree_, leaf_boxes_, stream_memory_, *pool_);
  }
  reporter_.report([&] { return AllPlaced{tree_.objects()}; });
}

/// Each object for itself, by the boxes as they are.
template <int D, class Trace>
void Bsp<D, Trace>::place_changes() {
  std::vector<ObjectId> leaving;
  std::vector<ObjectId> entering;
  for (const ObjectId object : changed_.all()) {
    const bool was_placed = tree_.table.is_placed(object);
    const bool is_placed = latest_.is_placed(object);
    if (was_placed && is_placed && stays(tree_, object, latest_.volume(object))) continue;
    if (was_placed) leaving.push_back(object);
    if (is_placed) entering.push_back(object);
  }
  for (const ObjectId object : leaving)
    if (!latest_.is_placed(object)) reporter_.report([&] { return ObjectPlaced{object, 0}; });
  displace<D>(tree_, tree_.root(), leaving);
  for (const ObjectId object : changed_.all()) tree_.table.copy(latest_, object);
  placed_ = 0;
  place_entering(entering);
}

template <int D, class Trace>
void Bsp<D, Trace>::place_entering(const std::vector<ObjectId>& entering) {
  for (const ObjectId object : entering) {
    const std::uint32_t leaves = kerf::place(tree_, tree_.root(), object, 0);
    reporter_.report([&] { return ObjectPlaced{object, leaves}; });
  }
  placed_ += entering.size();
}

#define KERF_INSTANTIATE(D, TRACE)              \
  template void Bsp<D, TRACE>::place();         \
  template void Bsp<D, TRACE>::put_at_rest();   \
  template void Bsp<D, TRACE>::place_all(bool); \
  template void Bsp<D, TRACE>::place_changes(); \
  template void Bsp<D, TRACE>::place_entering(const std::vector<ObjectId>&);
KERF_FOR_EACH_TRACE(KERF_INSTANTIATE)
#undef KERF_INSTANTIATE

}  // namespace kerf
