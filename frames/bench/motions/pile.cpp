#include "frames/bench/motions/pile.h"

#include <algorithm>
#include <cmath>

namespace kerf {
namespace {

/// Distance of columns in usual extents, such that a pile has 3 to 4 pairs an object.
template <int D>
constexpr Scalar kSpacing = D == 2 ? 0.6F : 0.95F;
constexpr Scalar kTouch =
    0.95F;  ///< of its extent: the height that an object adds to a column; boxes of neighbours overlap
constexpr Scalar kGravity = 0.01F;      ///< usual extents a step and step
constexpr Scalar kFastest = 0.5F;       ///< usual extents a step
constexpr Scalar kGlide = 0.3F;         ///< sideways, usual extents a step
constexpr double kRain = 0.15;          ///< falling objects in a unit of volume
constexpr Scalar kStir = 0.01F;         ///< usual extents a step
constexpr std::uint32_t kFlatness = 4;  ///< width of a pile over its height

/// Cells along an axis such that `count` objects make a pile of that flatness.
std::uint32_t width_for(std::uint32_t count, int dimension, double spacing, bool bucketed) {
  const double square = count * static_cast<double>(kFlatness) / (bucketed ? 0.8 : 1.0);
  return std::max(8U, static_cast<std::uint32_t>(std::pow(square / spacing, 1.0 / dimension)));
}

}  // namespace

template <int D>
Pile<D>::Pile(std::uint32_t count, std::uint64_t seed, const PileRules& rules)
    : Motion<D>(seed), rules_(rules), heap_(width_for(count, D, kSpacing<D>, rules.buckets != 0), D - 1) {
  if (rules.buckets != 0) build_walls();
  const auto fixed = std::min(static_cast<std::uint32_t>(this->boxes_.size()), count - 1);
  const std::vector<Box<D>> walls(this->boxes_.begin(), this->boxes_.begin() + fixed);
  this->moving_ = count - fixed;
  this->boxes_.resize(this->moving_);
  grains_.resize(this->moving_);
  for (std::uint32_t h = 0; h < rules.heaps; ++h)
    spouts_.push_back(this->vector_within(0.2, 0.8) * static_cast<Scalar>(heap_.width()));
  fill();
  this->boxes_.insert(this->boxes_.end(), walls.begin(), walls.end());
  this->bounds_ = this->cube(static_cast<double>(heap_.width()) * kSpacing<D>);
  this->bounds_.max[kUp] = ceiling_;
  for (const Box<D>& box : this->boxes_) this->bounds_ = join(this->bounds_, box);
}

template <int D>
Scalar Pile<D>::thickness(const Grain& grain) {
  return 2 * kTouch * grain.half[kUp];
}

template <int D>
Scalar Pile<D>::middle(Heap::Cell cell, int axis) const {
  return (static_cast<Scalar>(heap_.coordinate(cell, axis)) + 0.5F) * kSpacing<D>;
}

template <int D>
void Pile<D>::wall_off(Heap::Cell cell) {
  const std::uint32_t period = heap_.width() / rules_.buckets;
  for (int axis = 0; axis < kUp; ++axis)
    if (heap_.coordinate(cell, axis) % period == 0) heap_.make_wall(cell);
}

/// A bucket is a floor and, along each horizontal axis, the wall before it; the world's far sides stay open.
template <int D>
void Pile<D>::build_walls() {
  for (Heap::Cell cell = 0; cell < heap_.cells(); ++cell) wall_off(cell);
  const std::uint32_t period = heap_.width() / rules_.buckets;
  const Scalar size = static_cast<Scalar>(period) * kSpacing<D>;
  const Scalar high = 1.5F * kSpacing<D> * static_cast<Scalar>(heap_.width()) / kFlatness;
  for (Heap::Cell cell = 0; cell < heap_.cells(); ++cell) {
    Vector<D> corner;
    bool is_corner = true;
    for (int axis = 0; axis < kUp; ++axis) {
      is_corner &= heap_.coordinate(cell, axis) % period == 0;
      corner[axis] = static_cast<Scalar>(heap_.coordinate(cell, axis)) * kSpacing<D>;
    }
    if (!is_corner) continue;
    Vector<D> far = corner + this->along_all(size);
    far[kUp] = 0;
    corner[kUp] = -1;
    fixed_box(corner, far);
    corner[kUp] = 0;
    far[kUp] = high;
    for (int axis = 0; axis < kUp; ++axis) {
      Vector<D> thin = far;
      thin[axis] = corner[axis] + kSpacing<D>;
      fixed_box(corner, thin);
    }
  }
}

/// The pile first, by dropping objects to rest at once, then the rain above it.
template <int D>
void Pile<D>::fill() {
  const auto resting = static_cast<std::uint32_t>((1 - rules_.in_air) * this->moving_);
  for (std::uint32_t k = 0; k < this->moving_; ++k) {
    grains_[k].half = this->usual_half();
    aim(grains_[k], drop_cell());
    if (k >= resting) continue;
    for (auto next = heap_.downhill(grains_[k].cell); next; next = heap_.downhill(grains_[k].cell))
      aim(grains_[k], *next);
    for (int axis = 0; axis < kUp; ++axis) grains_[k].place[axis] = grains_[k].goal[axis];
    settle(k);
    top_ = std::max(top_, heap_.height(grains_[k].cell) + 2);
  }
  const double area = std::pow(static_cast<double>(heap_.width()) * kSpacing<D>, D - 1);
  ceiling_ = top_ + static_cast<Scalar>((this->moving_ - resting) / (area * kRain));
  for (std::uint32_t k = resting; k < this->moving_; ++k) {
    lift(k);
    grains_[k].place[kUp] = static_cast<Scalar>(this->uniform(top_, ceiling_));
    grains_[k].speed = kFastest;
  }
  for (std::uint32_t k = 0; k < this->moving_; ++k)
    this->boxes_[k] = this->around(grains_[k].place, grains_[k].half);
}

/// Around a spout, by a sum of uniform numbers that approximates a Gaussian; else anywhere.
template <int D>
Heap::Cell Pile<D>::drop_cell() {
  if (spouts_.empty()) return heap_.random_cell(this->random_);
  const Vector<D>& spout = spouts_[this->random_.below(static_cast<std::uint32_t>(spouts_.size()))];
  const double spread = 0.2 * heap_.width();
  Heap::Cell cell = 0;
  for (int axis = kUp - 1; axis >= 0; --axis) {
    const double off = this->uniform(-spread, spread);
    const double along = spout[axis] + off + this->uniform(-spread, spread);
    cell = cell * heap_.width() +
           static_cast<Heap::Cell>(std::clamp(along, 0.0, static_cast<double>(heap_.width() - 1)));
  }
  return heap_.is_wall(cell) ? heap_.random_cell(this->random_) : cell;
}

/// Sends a falling object to some point of a cell.
template <int D>
void Pile<D>::aim(Grain& grain, Heap::Cell cell) {
  constexpr double kJitter = 0.35;
  grain.cell = cell;
  for (int axis = 0; axis < kUp; ++axis)
    grain.goal[axis] =
        middle(cell, axis) + static_cast<Scalar>(this->uniform(-kJitter, kJitter)) * kSpacing<D>;
}

template <int D>
void Pile<D>::settle(std::uint32_t object) {
  Grain& grain = grains_[object];
  grain.place[kUp] = heap_.height(grain.cell) + grain.half[kUp];
  grain.stir = {};
  grain.rests = true;
  heap_.put(grain.cell, object, thickness(grain));
}

template <int D>
void Pile<D>::lift(std::uint32_t object) {
  Grain& grain = grains_[object];
  aim(grain, drop_cell());
  for (int axis = 0; axis < kUp; ++axis) grain.place[axis] = grain.goal[axis];
  grain.place[kUp] = ceiling_;
  grain.speed = kFastest;
  grain.rests = false;
  falling_.push_back(object);
}

template <int D>
void Pile<D>::lift_another() {
  for (;;) {
    const auto object = heap_.take(heap_.random_cell(this->random_));
    if (!object) continue;
    lift(*object);
    return;
  }
}

/// Down and towards the aim; farther down if the slope is steep; to rest if it is not.
template <int D>
void Pile<D>::fall(std::uint32_t object) {
  Grain& grain = grains_[object];
  grain.speed = std::min(grain.speed + kGravity, kFastest);
  bool is_there = true;
  for (int axis = 0; axis < kUp; ++axis) {
    const Scalar way = grain.goal[axis] - grain.place[axis];
    grain.place[axis] += std::clamp(way, -kGlide, kGlide);
    is_there &= std::abs(way) <= kGlide;
  }
  const Scalar rest = heap_.height(grain.cell) + grain.half[kUp];
  const bool is_down = grain.place[kUp] - grain.speed <= rest;
  if (!is_down) grain.place[kUp] -= grain.speed;
  if (!is_down || !is_there) return;
  if (const auto next = heap_.downhill(grain.cell)) {
    aim(grain, *next);
    grain.speed = 0;
  } else {
    settle(object);
  }
}

template <int D>
void Pile<D>::stir(std::uint32_t object) {
  constexpr Scalar kBack = 0.9F;
  grains_[object].stir = grains_[object].stir * kBack + this->vector_within(-kStir, kStir);
}

/// Some topmost objects leave their column for a neighbour that is not higher.
template <int D>
void Pile<D>::slide() {
  for (std::uint32_t k = 0; k < this->moving_ / rules_.slides_one_in; ++k) {
    const Heap::Cell from = heap_.random_cell(this->random_);
    const auto to = heap_.sideways(from, this->random_);
    const auto object = to ? heap_.take(from) : std::nullopt;
    if (!object) continue;
    aim(grains_[*object], *to);
    grains_[*object].speed = 0;
    grains_[*object].rests = false;
    falling_.push_back(*object);
  }
}

template <int D>
void Pile<D>::advance() {
  if (rules_.slides_one_in != 0) slide();
  std::uint32_t landed = 0;
  for (std::size_t k = 0; k < falling_.size();) {
    fall(falling_[k]);
    if (!grains_[falling_[k]].rests) {
      ++k;
      continue;
    }
    falling_[k] = falling_.back();
    falling_.pop_back();
    ++landed;
  }
  if (rules_.in_air > 0)
    for (std::uint32_t k = 0; k < landed; ++k) lift_another();
  for (std::uint32_t k = 0; k < this->moving_; ++k) {
    const Grain& grain = grains_[k];
    if (grain.rests) stir(k);
    this->boxes_[k] = this->around(grain.rests ? grain.place + grain.stir : grain.place, grain.half);
  }
}

template class Pile<2>;
template class Pile<3>;

}  // namespace kerf
