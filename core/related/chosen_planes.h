#pragma once

#include <string_view>

#include "core/base/random.h"
#include "core/related/plane_tree.h"

namespace kerf {

/// Candidates from a fixed set of directions, as the paper has them: 2 sqrt(n) of them, each at the median of
/// the objects' centres; that which leaves the fewest comparisons wins. The yardstick for the two below.
template <int D>
class FixedDirections final : public PlaneTree<D> {
 public:
  [[nodiscard]] std::string_view name() const override { return "fixed-directions"; }

 private:
  [[nodiscard]] std::optional<Plane<D>> choose(std::span<const ObjectId> objects) override;
};

/// Candidates by principal components: S. Gottschalk, M. Lin and D. Manocha, "OBBTree: a hierarchical
/// structure for rapid interference detection" (SIGGRAPH 1996).
///
/// Read for boxes: the eigenvectors of the covariance of the objects' centres, that of the greatest variance
/// first, through their mean; the next one is tried where one divides nothing.
template <int D>
class PrincipalComponents final : public PlaneTree<D> {
 public:
  [[nodiscard]] std::string_view name() const override { return "principal-components"; }

 private:
  [[nodiscard]] std::optional<Plane<D>> choose(std::span<const ObjectId> objects) override;
};

/// Candidates by evolution: T. Cassen, K. Subramanian and Z. Michalewicz, "Near-optimal construction of
/// partitioning trees using evolutionary techniques" (Graphics Interface 1995).
///
/// Read for boxes: a population of planes, each given by a direction and by the object through whose centre
/// it goes. In each generation the better half lives on, and its children are mixed of two parents'
/// directions and turned a little at random. Fit is what leaves few comparisons. Random numbers begin anew in
/// each step.
template <int D>
class EvolvedPlanes final : public PlaneTree<D> {
 public:
  static constexpr std::size_t kPopulation = 16;
  static constexpr int kGenerations = 8;
  static constexpr double kMutation = 0.3;  ///< of a component of a direction, at most

  [[nodiscard]] std::string_view name() const override { return "evolved-planes"; }

 private:
  struct Individual {
    Plane<D> plane;
    double cost = 0;
  };
  [[nodiscard]] std::optional<Plane<D>> choose(std::span<const ObjectId> objects) override;
  [[nodiscard]] Individual individual(std::span<const ObjectId> objects, const Vector<D>& normal,
                                      Random& random) const;
  [[nodiscard]] Individual child(std::span<const ObjectId> objects, const std::vector<Individual>& parents,
                                 Random& random) const;
};

}  // namespace kerf
