#include "tests/support/moving_boxes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/support/boxes.h"

namespace kerf::test {

template <int D>
MovingBoxes<D>::MovingBoxes(BroadPhase<D>& broad_phase, double world, double reach, std::uint64_t seed)
    : broad_phase_(broad_phase), random_(seed), world_(world), reach_(reach) {}

template <int D>
typename MovingBoxes<D>::Member MovingBoxes<D>::random_member() {
  Member member;
  member.center = random_point<D>(random_, 0, world_);
  member.half = random_point<D>(random_, 0, reach_);
  member.velocity = random_point<D>(random_, -1, 1);
  return member;
}

template <int D>
void MovingBoxes<D>::insert(ObjectId object) {
  const Member& member = crowd_[object.index()];
  const Box<D> box{member.center - member.half, member.center + member.half};
  EXPECT_EQ(broad_phase_.insert(object, box, member.fixed ? Mobility::fixed : Mobility::moving), Status::ok);
}

template <int D>
void MovingBoxes<D>::add(std::uint32_t count, std::uint32_t fixed_every) {
  for (std::uint32_t i = 0; i < count; ++i) {
    ObjectId object{static_cast<std::uint32_t>(crowd_.size())};
    if (unused_.empty()) {
      crowd_.emplace_back();
    } else {
      object = unused_.back();
      unused_.pop_back();
    }
    crowd_[object.index()] = random_member();
    crowd_[object.index()].fixed = fixed_every != 0 && i % fixed_every == 0;
    alive_.push_back(object);
    insert(object);
  }
}

template <int D>
void MovingBoxes<D>::remove(std::uint32_t count) {
  for (std::uint32_t i = 0; i < count && !alive_.empty(); ++i) {
    const std::uint32_t k = random_.below(size());
    const ObjectId object = alive_[k];
    EXPECT_EQ(broad_phase_.remove(object), Status::ok);
    alive_[k] = alive_.back();
    alive_.pop_back();
    std::erase(damaged_, object);
    unused_.push_back(object);
  }
}

template <int D>
void MovingBoxes<D>::replace(std::uint32_t count) {
  for (std::uint32_t i = 0; i < count; ++i) {
    const ObjectId object = any();
    EXPECT_EQ(broad_phase_.remove(object), Status::ok);
    std::erase(damaged_, object);
    const bool fixed = crowd_[object.index()].fixed;
    crowd_[object.index()] = random_member();
    crowd_[object.index()].fixed = !fixed;
    insert(object);
  }
}

template <int D>
template <class Change>
void MovingBoxes<D>::move_all(Change change) {
  for (const ObjectId object : alive_) {
    if (crowd_[object.index()].fixed) continue;
    change(crowd_[object.index()]);
    send(object);
  }
}

template <int D>
void MovingBoxes<D>::send(ObjectId object) {
  const Member& member = crowd_[object.index()];
  EXPECT_EQ(broad_phase_.move(object, {member.center - member.half, member.center + member.half}),
            Status::ok);
  std::erase(damaged_, object);
}

template <int D>
void MovingBoxes<D>::walk(double distance) {
  move_all(
      [&](Member& member) { member.center = member.center + random_point<D>(random_, -distance, distance); });
}

template <int D>
void MovingBoxes<D>::bounce(double time) {
  move_all([&](Member& member) {
    member.center = member.center + member.velocity * static_cast<Scalar>(time);
    for (int axis = 0; axis < D; ++axis) {
      const bool outward =
          member.velocity[axis] < 0 ? member.center[axis] < 0 : double{member.center[axis]} > world_;
      if (outward) member.velocity[axis] = -member.velocity[axis];
    }
  });
}

template <int D>
void MovingBoxes<D>::teleport() {
  move_all([&](Member& member) { member.center = random_point<D>(random_, 0, world_); });
}

template <int D>
void MovingBoxes<D>::gather(double share) {
  const Vector<D> middle = all<D>(static_cast<Scalar>(world_ / 2));
  move_all([&](Member& member) {
    member.center = member.center + (middle - member.center) * static_cast<Scalar>(share);
  });
}

template <int D>
void MovingBoxes<D>::scale(double factor) {
  move_all([&](Member& member) { member.half = member.half * static_cast<Scalar>(factor); });
}

template <int D>
void MovingBoxes<D>::damage(std::uint32_t count) {
  for (std::uint32_t i = 0; i < count; ++i) {
    const ObjectId object = any();
    const Member& member = crowd_[object.index()];
    Box<D> box{member.center - member.half, member.center + member.half};
    const auto axis = static_cast<int>(random_.below(D));
    const std::uint32_t kind = random_.below(4);
    if (kind == 0) box.min[axis] = std::numeric_limits<Scalar>::quiet_NaN();
    if (kind == 1) box.max[axis] = std::numeric_limits<Scalar>::quiet_NaN();
    if (kind == 2) box.min[axis] = box.max[axis] + 1;
    if (kind == 3) box.max[axis] = std::numeric_limits<Scalar>::infinity();
    EXPECT_EQ(broad_phase_.move(object, box), kind == 3 ? Status::clamped : Status::quarantined);
    damaged_.push_back(object);
  }
}

template <int D>
void MovingBoxes<D>::heal() {
  while (!damaged_.empty()) send(damaged_.back());
}

template <int D>
ObjectId MovingBoxes<D>::any() {
  return alive_[random_.below(size())];
}

template class MovingBoxes<2>;
template class MovingBoxes<3>;

}  // namespace kerf::test
