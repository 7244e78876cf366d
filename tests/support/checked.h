#pragma once

#include <gtest/gtest.h>

#include "core/broad_phase/brute_force.h"
#include "tests/support/pairs.h"

namespace kerf::test {

/// A broad phase beside the oracle: every request goes to both, and after every step the answers are
/// compared. It can stand wherever a broad phase is asked for, for example in a scene.
template <int D>
class Checked final : public BroadPhase<D> {
 public:
  explicit Checked(BroadPhase<D>& subject) : subject_(subject), oracle_(subject.volume_kind()) {}

  [[nodiscard]] std::string_view name() const override { return subject_.name(); }
  [[nodiscard]] VolumeKind volume_kind() const override { return subject_.volume_kind(); }
  Status insert(ObjectId object, const Box<D>& box, Mobility mobility) override {
    return same(subject_.insert(object, box, mobility), oracle_.insert(object, box, mobility), object);
  }
  Status insert(ObjectId object, const Volume<D>& volume, Mobility mobility) override {
    return same(subject_.insert(object, volume, mobility), oracle_.insert(object, volume, mobility), object);
  }
  Status move(ObjectId object, const Box<D>& box) override {
    return same(subject_.move(object, box), oracle_.move(object, box), object);
  }
  Status move(ObjectId object, const Volume<D>& volume) override {
    return same(subject_.move(object, volume), oracle_.move(object, volume), object);
  }
  Status remove(ObjectId object) override {
    return same(subject_.remove(object), oracle_.remove(object), object);
  }
  void step() override {
    subject_.step();
    oracle_.step();
    ++steps_;
    EXPECT_TRUE(same_pairs(subject_.pairs(), oracle_.pairs())) << "in step " << steps_;
  }
  [[nodiscard]] std::span<const Pair> pairs() const override { return subject_.pairs(); }

 private:
  Status same(Status subject, Status expected, ObjectId object) {
    EXPECT_EQ(to_string(subject), to_string(expected))
        << "for object " << object.value << " after step " << steps_;
    return subject;
  }

  BroadPhase<D>& subject_;
  BruteForce<D> oracle_;
  std::uint32_t steps_ = 0;
};

}  // namespace kerf::test
