#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/broad_phase/tabled.h"
#include "core/objects/structure.h"

namespace kerf {

/// A tree of spheres: P. Hubbard, "Collision detection for interactive graphics applications" (IEEE TVCG,
/// 1995).
///
/// Read for boxes: the spheres around the objects' boxes are grouped in halves by their centres, on the axis
/// on which these are spread most, and a group has a sphere around those of its halves. The tree is built
/// anew in each step. Two groups are looked into while their spheres meet; boxes are compared where single
/// ones do.
template <int D>
class SphereTree final : public Tabled<D>, public SelfDescribing<D> {
 public:
  [[nodiscard]] std::string_view name() const override { return "sphere-tree"; }
  /// Pairs of spheres and of boxes that the last `step()` compared.
  [[nodiscard]] std::uint64_t candidates() const { return candidates_; }
  /// The tests are those of boxes, of objects whose spheres meet.
  void describe(StructureParts<D>& parts) const override;

 private:
  struct Sphere {
    std::array<double, D> centre{};
    double radius = 0;
  };
  struct Node {
    Sphere sphere;
    std::int32_t first = -1;  ///< child; -1: it is an object
    std::int32_t second = -1;
    ObjectId object;
  };

  static Sphere around(const Box<D>& box);
  static Sphere around(const Sphere& a, const Sphere& b);
  static bool meet(const Sphere& a, const Sphere& b);
  void arrange() override;
  void find_pairs(PairList& pairs) override;
  std::int32_t build(std::size_t begin, std::size_t end);
  /// Calls `visit(a, b, meet)` for each two nodes whose spheres are compared.
  template <class Visit>
  void for_each_test(const Visit& visit) const;
  /// By node: around its sphere, and around its children's boxes.
  [[nodiscard]] std::vector<Box<D>> boxes_of_nodes() const;

  std::vector<Node> objects_;
  std::vector<Node> nodes_;  ///< the root is the last
  std::uint64_t candidates_ = 0;
};

}  // namespace kerf
