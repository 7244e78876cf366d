#pragma once

#include <vector>

#include "frames/bench/motion.h"
#include "frames/bench/motions/heap.h"

namespace kerf {

/// The beginning and the motion of a pile.
struct PileRules {
  double in_air = 0;                ///< share of the objects that fall
  std::uint32_t heaps = 0;          ///< objects come down around so many points; 0: evenly
  std::uint32_t buckets = 0;        ///< along each horizontal axis; 0: none
  std::uint32_t slides_one_in = 0;  ///< objects for each that slides a step; 0: none slides
};

/// Objects that fall, come to rest on a heap and stir there. The last axis is up. It is no physics, but has
/// what matters to a broad phase: columns of touching boxes, slopes, a loose rain above, small motion below.
template <int D>
class Pile : public Motion<D> {
 public:
  Pile(std::uint32_t count, std::uint64_t seed, const PileRules& rules);
  void advance() override;

 private:
  static constexpr int kUp = D - 1;
  struct Grain {
    Vector<D> half;
    Vector<D> place;  ///< the centre, but for the stirring when at rest
    Vector<D> stir;
    Vector<D> goal;       ///< the point above which it will come down
    Heap::Cell cell = 0;  ///< on which it rests or to which it falls
    Scalar speed = 0;
    bool rests = true;
  };

  void build_walls();
  void wall_off(Heap::Cell cell);
  void fill();
  [[nodiscard]] Heap::Cell drop_cell();
  void aim(Grain& grain, Heap::Cell cell);
  void settle(std::uint32_t object);
  void fall(std::uint32_t object);
  void stir(std::uint32_t object);
  void slide();
  void lift(std::uint32_t object);
  void lift_another();
  [[nodiscard]] static Scalar thickness(const Grain& grain);
  [[nodiscard]] Scalar middle(Heap::Cell cell, int axis) const;
  void fixed_box(Vector<D> low, Vector<D> high) { this->boxes_.push_back({low, high}); }

  PileRules rules_;
  Heap heap_;
  Scalar top_ = 0;      ///< where the rain begins
  Scalar ceiling_ = 0;  ///< and its end
  std::vector<Grain> grains_;
  std::vector<std::uint32_t> falling_;
  std::vector<Vector<D>> spouts_;
};

}  // namespace kerf
