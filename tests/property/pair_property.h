#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/base/random.h"
#include "core/geometry/volume.h"
#include "core/tree/tree.h"

namespace kerf::test {

/// What a run of the property has seen. Sound means: nothing but zeros behind `intervals`.
struct PropertyCount {
  std::uint64_t trees = 0;
  std::uint64_t pairs = 0;      ///< overlapping pairs, each looked for in one tree
  std::uint64_t intervals = 0;  ///< of such pairs, compared along one direction
  std::uint64_t apart = 0;      ///< of them, those that do not overlap
  std::uint64_t missed = 0;     ///< pairs that no leaf reported
  std::uint64_t twice = 0;      ///< pairs reported again
  std::uint64_t invented = 0;   ///< reported without overlapping
  std::string first;            ///< the first finding, so that it can be had again

  [[nodiscard]] std::uint64_t findings() const { return apart + missed + twice + invented; }
};

/// The property on which exactness rests (DESIGN.md, "Correct pairs"): volumes that overlap have intervals
/// that overlap along every direction, and the canonical-leaf rule reports each pair exactly once, whatever
/// planes the tree is made of. It is tried on crowds of hard volumes in small trees of random planes, most of
/// them exactly at the end of an object or an ulp beside it.
template <int D>
class PairProperty {
 public:
  PairProperty(VolumeKind kind, std::uint64_t seed) : kind_(kind), seed_(seed) {}

  /// Tries one tree. The n-th call does the same in every run with the same seed.
  void try_tree();
  [[nodiscard]] const PropertyCount& count() const { return count_; }

 private:
  void fill(kerf::Tree<D>& tree, Random& random) const;
  void compare_intervals(const kerf::Tree<D>& tree, const std::vector<Pair>& expected);
  void compare_pairs(kerf::Tree<D>& tree, const std::vector<Pair>& expected);
  void note(std::uint64_t& counter, const char* what, const Pair& pair);

  VolumeKind kind_;
  std::uint64_t seed_;
  std::shared_ptr<const Projector<D>> projector_;
  PropertyCount count_;
};

}  // namespace kerf::test
