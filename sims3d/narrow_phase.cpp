#include "sims3d/narrow_phase.h"

#include <algorithm>
#include <iterator>

namespace kerf {
namespace {

/// Appends the contact points of two geoms to `points` and returns their number.
std::uint32_t collide(Pair pair, std::span<const Geom> geoms, std::vector<dContactGeom>& points) {
  const std::size_t begin = points.size();
  points.resize(begin + NarrowPhase::kMaxPoints);
  const int count = dCollide(geoms[pair.a.index()].geom.get(), geoms[pair.b.index()].geom.get(),
                             NarrowPhase::kMaxPoints, &points[begin], sizeof(dContactGeom));
  points.resize(begin + static_cast<std::size_t>(count));
  return static_cast<std::uint32_t>(count);
}

/// Whether a sorted list holds `pair`, for ascending calls: `at` only ever moves forward.
bool holds(std::span<const Pair> list, std::size_t& at, Pair pair) {
  while (at < list.size() && list[at] < pair) ++at;
  return at < list.size() && list[at] == pair;
}

}  // namespace

void NarrowPhase::run(std::span<const Pair> candidates, std::span<const Geom> geoms,
                      std::span<const std::uint8_t> moved) {
  std::swap(contacts_, last_contacts_);
  contacts_.clear();
  touches_.clear();
  points_.clear();
  std::size_t known = 0;
  std::size_t touched = 0;
  for (const Pair pair : candidates) {
    const bool rests = moved[pair.a.index()] == 0 && moved[pair.b.index()] == 0;
    if (!(rests && holds(last_candidates_, known, pair))) {
      test(pair, geoms);
    } else if (holds(last_contacts_, touched, pair)) {
      touches_.push_back({pair, 0, 0});
    }
  }
  remember(candidates);
}

void NarrowPhase::test(Pair pair, std::span<const Geom> geoms) {
  const auto first = static_cast<std::uint32_t>(points_.size());
  const std::uint32_t count = collide(pair, geoms, points_);
  if (count > 0) touches_.push_back({pair, first, count});
}

void NarrowPhase::remember(std::span<const Pair> candidates) {
  last_candidates_.assign(candidates.begin(), candidates.end());
  for (const Touch& touch : touches_) contacts_.push_back(touch.pair);
  parted_.clear();
  std::set_difference(last_contacts_.begin(), last_contacts_.end(), contacts_.begin(), contacts_.end(),
                      std::back_inserter(parted_));
}

std::span<const dContactGeom> NarrowPhase::points(const Touch& touch, std::span<const Geom> geoms) {
  if (touch.count > 0) return std::span(points_).subspan(touch.first, touch.count);
  const std::size_t begin = points_.size();
  const std::uint32_t count = collide(touch.pair, geoms, points_);
  return std::span(points_).subspan(begin, count);
}

}  // namespace kerf
