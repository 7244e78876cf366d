#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/broad_phase/brute_force.h"

namespace kerf::sims3d_test {

/// The oracle with a seam: requests are counted, answers can be changed.
class Seam : public BroadPhase<3> {
 public:
  [[nodiscard]] std::string_view name() const override { return "seam"; }
  Status insert(ObjectId object, const Box<3>& box, Mobility mobility) override {
    ++inserted;
    if (mobility == Mobility::fixed) fixed.push_back(object);
    return oracle_.insert(object, box, mobility);
  }
  Status move(ObjectId object, const Box<3>& box) override {
    moved.push_back(object);
    return oracle_.move(object, box);
  }
  Status remove(ObjectId object) override { return oracle_.remove(object); }
  void step() override {
    oracle_.step();
    pairs_.assign(oracle_.pairs().begin(), oracle_.pairs().end());
    change(pairs_);
  }
  [[nodiscard]] std::span<const Pair> pairs() const override { return pairs_; }

  std::uint32_t inserted = 0;
  std::vector<ObjectId> fixed;
  std::vector<ObjectId> moved;

 protected:
  virtual void change(std::vector<Pair>& pairs) { static_cast<void>(pairs); }

 private:
  BruteForce<3> oracle_;
  std::vector<Pair> pairs_;
};

/// Never finds anything.
class Silent final : public Seam {
  void change(std::vector<Pair>& pairs) override { pairs.clear(); }
};

/// Right but in another order, each pair the wrong way round and twice.
class Disorderly final : public Seam {
  void change(std::vector<Pair>& pairs) override {
    std::reverse(pairs.begin(), pairs.end());
    for (Pair& pair : pairs) std::swap(pair.a, pair.b);
    const std::vector<Pair> once = pairs;
    pairs.insert(pairs.end(), once.begin(), once.end());
  }
};

/// Gives every two objects as a pair, whatever their boxes.
class Everything final : public Seam {
  void change(std::vector<Pair>& pairs) override {
    pairs.clear();
    for (std::uint32_t a = 0; a < inserted; ++a)
      for (std::uint32_t b = a + 1; b < inserted; ++b) pairs.push_back({{a}, {b}});
  }
};

/// Gives one pair of the test's choice besides the right ones.
class Inventive final : public Seam {
 public:
  Pair extra;

 private:
  void change(std::vector<Pair>& pairs) override { pairs.push_back(extra); }
};

}  // namespace kerf::sims3d_test
