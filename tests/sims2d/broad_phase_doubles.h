#pragma once

#include <algorithm>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "core/objects/broad_phase.h"

namespace kerf::test {

/// Accepts everything and reports nothing.
class SilentBroadPhase final : public BroadPhase<2> {
 public:
  [[nodiscard]] std::string_view name() const override { return "silent"; }
  Status insert(ObjectId, const Box<2>&, Mobility) override { return Status::ok; }
  Status move(ObjectId, const Box<2>&) override { return Status::ok; }
  Status remove(ObjectId) override { return Status::ok; }
  void step() override {}
  [[nodiscard]] std::span<const Pair> pairs() const override { return {}; }
};

/// Hands everything on to another broad phase, and lets a test look and meddle.
class WatchedBroadPhase final : public BroadPhase<2> {
 public:
  explicit WatchedBroadPhase(BroadPhase<2>& inner) : inner_(inner) {}

  [[nodiscard]] std::string_view name() const override { return "watched"; }
  Status insert(ObjectId object, const Box<2>& box, Mobility mobility) override {
    inserted.push_back(mobility);
    return inner_.insert(object, box, mobility);
  }
  Status move(ObjectId object, const Box<2>& box) override {
    moved.push_back(object);
    return inner_.move(object, box);
  }
  Status remove(ObjectId object) override { return inner_.remove(object); }
  void step() override {
    before_step();
    inner_.step();
    pairs_.assign(inner_.pairs().begin(), inner_.pairs().end());
    edit_pairs(pairs_);
  }
  [[nodiscard]] std::span<const Pair> pairs() const override { return pairs_; }

  /// Called when all boxes are set and the pairs have not been found yet.
  std::function<void()> before_step = [] {};
  /// May change what is reported.
  std::function<void(std::vector<Pair>&)> edit_pairs = [](std::vector<Pair>&) {};
  std::vector<Mobility> inserted;  ///< by object
  std::vector<ObjectId> moved;     ///< since the test last cleared it

 private:
  BroadPhase<2>& inner_;
  std::vector<Pair> pairs_;
};

}  // namespace kerf::test
