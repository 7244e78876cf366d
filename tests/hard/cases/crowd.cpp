#include "tests/hard/cases/crowd.h"

#include "tests/support/boxes.h"

namespace kerf::test {

template <int D>
Crowd<D>::Crowd(ScriptWriter<D>& out, std::uint32_t count, std::uint64_t seed, double reach,
                std::uint32_t first)
    : out_(out), random_(seed), world_(2.3 * reach * lattice_side<D>(count)), first_(first), members_(count) {
  for (Member& member : members_) {
    member.center = random_point<D>(random_, 0, world_);
    member.half = random_point<D>(random_, 0, reach);
  }
}

template <int D>
Box<D> Crowd<D>::box(std::uint32_t k) const {
  const Vector<D> center = members_[k].center + all<D>(static_cast<Scalar>(offset_));
  return {center - members_[k].half, center + members_[k].half};
}

template <int D>
void Crowd<D>::insert(std::uint32_t fixed_every) {
  for (std::uint32_t k = 0; k < size(); ++k) {
    members_[k].fixed = fixed_every != 0 && k % fixed_every == 0;
    out_.insert(first_ + k, box(k), Status::ok, members_[k].fixed ? Mobility::fixed : Mobility::moving);
  }
}

template <int D>
void Crowd<D>::send(std::uint32_t k) {
  out_.move(first_ + k, box(k));
}

template <int D>
template <class Change>
void Crowd<D>::move_all(Change change) {
  for (std::uint32_t k = 0; k < size(); ++k) {
    if (members_[k].fixed) continue;
    change(members_[k]);
    send(k);
  }
}

template <int D>
void Crowd<D>::walk(double distance) {
  move_all([&](Member& m) { m.center = m.center + random_point<D>(random_, -distance, distance); });
}

template <int D>
void Crowd<D>::teleport() {
  move_all([&](Member& m) { m.center = random_point<D>(random_, 0, world_); });
}

template <int D>
void Crowd<D>::gather(double share) {
  const Vector<D> middle = all<D>(static_cast<Scalar>(world_ / 2));
  move_all([&](Member& m) { m.center = m.center + (middle - m.center) * static_cast<Scalar>(share); });
}

template <int D>
void Crowd<D>::scale(double factor) {
  move_all([&](Member& m) { m.half = m.half * static_cast<Scalar>(factor); });
}

template class Crowd<2>;
template class Crowd<3>;

}  // namespace kerf::test
