#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/ids.h"
#include "sims3d/geoms.h"

namespace kerf {

/// Two objects that touch by ODE's collider.
struct Touch {
  Pair pair;
  std::uint32_t first = 0;  ///< where its contact points begin
  std::uint32_t count = 0;  ///< 0: known from an earlier step, neither object has moved since
};

/// Runs ODE's colliders on candidate pairs, and remembers the answers for pairs of objects that did not move:
/// what rests is not computed again.
class NarrowPhase {
 public:
  /// The most points a pair; the answer whether two objects touch does not depend on it.
  static constexpr int kMaxPoints = 8;

  /// `candidates` are sorted and without repetition. `moved[k]` says whether object k has another pose than
  /// at the last call. Afterwards `touches()` and `contacts()` are those of these candidates, in their order.
  void run(std::span<const Pair> candidates, std::span<const Geom> geoms,
           std::span<const std::uint8_t> moved);

  [[nodiscard]] std::span<const Touch> touches() const { return touches_; }
  [[nodiscard]] std::span<const Pair> contacts() const { return contacts_; }
  /// Pairs that touched at the previous call and do not, or are no candidates, at this one.
  [[nodiscard]] std::span<const Pair> parted() const { return parted_; }
  /// The touch's contact points, computed now if they were not. They are valid until the next call of any
  /// method.
  std::span<const dContactGeom> points(const Touch& touch, std::span<const Geom> geoms);

 private:
  void test(Pair pair, std::span<const Geom> geoms);
  void remember(std::span<const Pair> candidates);

  std::vector<Touch> touches_;
  std::vector<Pair> contacts_;
  std::vector<Pair> parted_;
  std::vector<dContactGeom> points_;
  std::vector<Pair> last_candidates_;
  std::vector<Pair> last_contacts_;
};

}  // namespace kerf
