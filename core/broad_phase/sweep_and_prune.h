#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/pair_set.h"
#include "core/broad_phase/tabled.h"
#include "core/objects/structure.h"

namespace kerf {

/// The world's axes along which objects are separated; those beyond the dimension mean nothing.
using AxisChoice = std::array<bool, 3>;

/// Sweep-and-prune as the paper's rival (section 6.1; Cohen et al. 1995): one list of all ends along each
/// axis, ordered by swaps of neighbours. An overlap along an axis begins or ends where one object's beginning
/// is swapped with another's end, so the set of overlaps changes only there.
///
/// Where the paper keeps an n by n matrix of overlaps, we keep a set: 100,000 objects would need 10 GB.
template <int D>
class SweepAndPrune final : public Tabled<D>, public SelfDescribing<D> {
 public:
  /// Lists are kept along the chosen axes only (the paper leaves Y out of its simulations 1 and 4); pairs are
  /// those that overlap along all axes, whatever the choice. Throws std::invalid_argument if none is chosen.
  explicit SweepAndPrune(const AxisChoice& axes = {true, true, true});

  [[nodiscard]] std::string_view name() const override { return "sweep-and-prune"; }
  /// How many pairs overlap along all chosen axes.
  [[nodiscard]] std::uint64_t candidates() const { return candidates_.pairs().size(); }
  /// The lists. What it tests are the candidates, which it compares along the axes that have no list.
  void describe(StructureParts<D>& parts) const override;

 private:
  /// One end of an object along an axis.
  struct End {
    Scalar value;
    std::uint32_t object;
    bool upper;
    /// Touching boxes overlap: of equal values a beginning comes before an end.
    friend bool operator<(const End& a, const End& b) {
      return a.value < b.value || (a.value == b.value && !a.upper && b.upper);
    }
  };
  struct List {
    int axis;
    std::vector<End> ends;
  };
  /// The state of an object in the lists.
  enum class Part : std::uint8_t { none, listed, listed_fixed };

  void arrange() override;
  void find_pairs(PairList& pairs) override;
  [[nodiscard]] Part part_of(ObjectId object) const;
  void drop_gone();
  void renew(List& list) const;
  void swap_into_order(List& list);
  void meet(const End& coming, const End& passed);
  void list_new();
  void find_pairs_of_new();
  [[nodiscard]] bool is_candidate(ObjectId a, ObjectId b) const;

  std::vector<List> lists_;
  std::vector<Part> parts_;  ///< by object
  std::vector<std::uint8_t> is_new_;
  std::vector<ObjectId> new_;
  PairSet candidates_;
};

}  // namespace kerf
