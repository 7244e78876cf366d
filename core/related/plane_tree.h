#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/broad_phase/tabled.h"
#include "core/geometry/plane.h"
#include "core/objects/structure.h"

namespace kerf {

/// A tree of planes in any direction that is built from nothing in each step: what its policies share. They
/// differ in which planes they try.
///
/// An object is in each leaf that it reaches. Two that overlap share a side of each plane; where both lie on
/// both sides of it, they are compared on its left, and so once.
template <int D>
class PlaneTree : public Tabled<D>, public SelfDescribing<D> {
 public:
  static constexpr std::size_t kCrowded = 16;  ///< objects of a leaf that is worth a plane
  static constexpr std::uint32_t kDeepest = 40;

  /// Pairs of boxes that the last `step()` compared.
  [[nodiscard]] std::uint64_t candidates() const { return candidates_; }
  void describe(StructureParts<D>& parts) const final;

 protected:
  /// The partitioner for these objects; none if none is worth it.
  [[nodiscard]] virtual std::optional<Plane<D>> choose(std::span<const ObjectId> objects) = 0;

  /// How many objects lie left and right of a plane, those on both sides in both.
  struct Split {
    std::size_t left = 0;
    std::size_t right = 0;
    /// Comparisons that are left, each of a side with each.
    [[nodiscard]] double cost() const {
      return static_cast<double>(left) * static_cast<double>(left) +
             static_cast<double>(right) * static_cast<double>(right);
    }
  };
  [[nodiscard]] Split split(std::span<const ObjectId> objects, const Plane<D>& plane) const;
  /// Both sides are smaller, and few objects are on both.
  [[nodiscard]] static bool pays(const Split& split, std::size_t objects);
  /// At the median of the objects' centres.
  [[nodiscard]] Plane<D> middle_plane(std::span<const ObjectId> objects, const Vector<D>& normal);

 private:
  struct Member {
    ObjectId object;
    std::uint64_t both = 0;  ///< bit k: it lies on both sides of the plane at depth k above
  };
  struct Node {
    Plane<D> plane;
    std::uint32_t left = kNoPart;  ///< of a leaf none
    std::uint32_t right = kNoPart;
    std::uint32_t depth = 0;
    std::uint64_t turns = 0;  ///< bit k: it lies right of the plane at depth k
    std::vector<Member> members{};
  };

  void arrange() final;
  void find_pairs(PairList& pairs) final;
  /// False if the leaf stays one.
  bool divide(std::uint32_t leaf);
  template <class Visit>
  void for_each_test(const Node& leaf, const Visit& visit) const;

  std::vector<Node> nodes_;  ///< the root first
  std::vector<ObjectId> objects_;
  std::vector<Scalar> places_;
  std::uint64_t candidates_ = 0;
};

}  // namespace kerf
