#pragma once

#include <array>
#include <vector>

#include "core/related/cut_tree_policy.h"

namespace kerf {

/// A tree that is changed when a prediction says so: P. Agarwal, L. Guibas, T. Murali and J. Vitter,
/// "Cylindrical static and kinetic binary space partitions" (SoCG 1997); P. Agarwal, J. Erickson and L.
/// Guibas, "Kinetic binary space partitions for intersecting segments and disjoint triangles" (SODA 1998); J.
/// Comba, "Kinetic vertical decomposition trees" (2000).
///
/// Read for boxes: an object moves on as in its last step, and its certificate holds until one of its bounds
/// could reach a cut on the way to its leaves. While it does, and the object is on its course, the tree is as
/// it was. A certificate that fails stores its object anew; an object that leaves its course, too, since what
/// was known of it no longer holds. The tree is built anew when it has twice the entries it began with.
template <int D>
class KineticTree final : public CutTreePolicy<D> {
 public:
  [[nodiscard]] std::string_view name() const override { return "kinetic-tree"; }
  /// In the last step: certificates that failed, and objects that were not on their courses.
  [[nodiscard]] std::uint64_t failures() const { return failures_; }
  [[nodiscard]] std::uint64_t surprises() const { return surprises_; }

 private:
  using Index = typename CutTree<D>::Index;
  using Bounds = std::array<double, std::size_t{2} * D>;  ///< the lower ones, then the upper ones
  struct Course {
    Bounds begin{};        ///< at the step `from`
    Bounds velocity{};     ///< a step
    double tolerance = 0;  ///< so near to its course an object is on it
    std::uint32_t from = 0;
    std::uint32_t until = 0;  ///< the last step in which the certificate holds
  };

  static Bounds bounds_of(const Box<D>& box);
  void arrange() override;
  void build();
  /// Of an object that is stored, which goes on with a velocity.
  void certify(ObjectId object, const Bounds& velocity);
  [[nodiscard]] std::uint32_t holds_until(const Course& course, const Box<D>& box) const;
  [[nodiscard]] bool is_on_course(const Course& course, const Bounds& bounds) const;
  void follow(ObjectId object);

  std::vector<Course> courses_;  ///< by object
  std::vector<Index> leaves_;    ///< not used further
  std::uint32_t step_ = 0;
  std::uint64_t failures_ = 0;
  std::uint64_t surprises_ = 0;
  std::size_t entries_when_built_ = 0;
};

}  // namespace kerf
