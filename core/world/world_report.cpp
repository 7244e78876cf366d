// Which pairs are reported, and how they compare with those of the step before.

#include <algorithm>
#include <utility>

#include "core/base/float_mode.h"
#include "core/world/world.h"

namespace kerf {
namespace {

/// Sets a flag while it lives.
class Raised {
 public:
  explicit Raised(bool& flag) : flag_(flag) { flag_ = true; }
  ~Raised() { flag_ = false; }
  Raised(const Raised&) = delete;
  Raised& operator=(const Raised&) = delete;

 private:
  bool& flag_;
};

}  // namespace

template <int D>
Box<D> World<D>::exact_box(ObjectId object) const {
  return is_thick(defs_[object.index()].margin) ? exact_[object.index()] : tree_->objects().box(object);
}

template <int D>
bool World<D>::may_report(ObjectId a, ObjectId b) const {
  if (filters_ > 0 && !may_pair(defs_[a.index()].filter, defs_[b.index()].filter)) return false;
  return options_.pairs_of == PairsOf::fat_boxes || margins_ == 0 || overlaps(exact_box(a), exact_box(b));
}

template <int D>
WorldPair World<D>::describe(std::uint32_t a, Partner b) const {
  return {slots_.handle(a), slots_.handle(b.index()), b.is_flagged() ? WorldPair::kSensor : 0, 0};
}

/// Orders the pairs that are reported in `next_rows_`.
template <int D>
void World<D>::gather() {
  const std::span<const Pair> all = tree_->pairs();
  const bool is_exact = options_.pairs_of == PairsOf::fat_boxes || margins_ == 0;
  if (filters_ == 0 && sensors_ == 0 && is_exact) {
    next_rows_.assign(all, slots_.size(), rows_);
  } else {
    const UsualComparisons comparisons;
    allowed_.clear();
    for (const Pair& pair : all) {
      if (!may_report(pair.a, pair.b)) continue;
      const bool is_sensor = defs_[pair.a.index()].kind == ObjectKind::sensor ||
                             defs_[pair.b.index()].kind == ObjectKind::sensor;
      allowed_.push_back({pair.a, {make_partner(pair.b.value, is_sensor).value}});
    }
    next_rows_.assign_flagged(allowed_, slots_.size(), rows_);
  }
  if (!callback_) return;
  const Raised asking(is_asking_);
  next_rows_.filter([this](std::uint32_t a, Partner b) { return callback_(describe(a, b)); });
}

/// Compares with the step before. What both steps have is copied: an index that is in pairs of both was not
/// given to another object between them. Nothing that was reported changes before all memory is there.
template <int D>
void World<D>::report() {
  next_begun_.clear();
  next_ended_.clear();
  next_pairs_.resize(next_rows_.size());
  const std::span<const Partner> old = rows_.partners();
  const std::span<const Partner> now = next_rows_.partners();
  std::size_t seen = 0;
  std::size_t made = 0;
  const auto copy_until = [&](std::size_t place) {
    const auto from = pairs_.begin() + static_cast<std::ptrdiff_t>(seen);
    std::copy_n(from, place - made, next_pairs_.begin() + static_cast<std::ptrdiff_t>(made));
    seen += place - made;
    made = place;
  };
  compare_rows(
      rows_, next_rows_,
      [&](std::uint32_t a, std::size_t k) {
        copy_until(made + (k - seen));
        next_ended_.push_back(describe(a, old[seen++]));
      },
      [&](std::uint32_t a, std::size_t i) {
        copy_until(i);
        next_begun_.push_back(describe(a, now[i]));
        next_pairs_[made++] = next_begun_.back();
      });
  copy_until(now.size());
  std::swap(rows_, next_rows_);
  pairs_.swap(next_pairs_);
  begun_.swap(next_begun_);
  ended_.swap(next_ended_);
}

#define KERF_INSTANTIATE(D)                                     \
  template Box<D> World<D>::exact_box(ObjectId) const;          \
  template bool World<D>::may_report(ObjectId, ObjectId) const; \
  template void World<D>::gather();                             \
  template void World<D>::report();
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
