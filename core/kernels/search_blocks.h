#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/geometry/box.h"
#include "core/kernels/wide_block.h"

namespace kerf {

// What kernels ask of the boxes of a block at once. The floats err on the side of "possible"; where they
// cannot be sure, the caller must look at the box itself.

/// A cast: on each axis a box is met first with its near end, left with its far end.
template <int D>
struct CastTest {
  std::array<Scalar, D> start{};        ///< the end of the moving box that meets the near end, at t = 0
  std::array<Scalar, D> near_start{};   ///< the same, or beyond it by more than denormals can be
  std::array<Scalar, D> far_start{};    ///< the end that leaves the far end, or before it by as much
  std::array<Scalar, D> near_factor{};  ///< 1 / direction, smaller by more than all roundings
  std::array<Scalar, D> far_factor{};   ///< larger
  std::array<double, D>
      direction{};           ///< by which t is computed; 0: the ends must be on their sides for all t
  bool moves_on_all = true;  ///< no direction is 0
  Scalar blur = 0;           ///< by which near and far may be too far apart together
  Scalar max_t = 0;
};

/// Squared distances from a centre: at most `sure` is surely inside, above `possible` surely not.
template <int D>
struct BallTest {
  std::array<Scalar, D> center{};
  Scalar possible = 0;
  Scalar sure = 0;
};

/// The left side of a plane; components of the normal are at most 1/4.
template <int D>
struct RoundedHalfSpace {
  std::array<Scalar, D> normal{};
  Scalar possible = 0;  ///< the offset, rounded up
  Scalar sure = 0;      ///< rounded down
};

template <int D>
struct HalfSpacesTest {
  std::span<const RoundedHalfSpace<D>> all;
};

/// Where findings go: objects by id, or hits.
template <class Finding>
struct FoundRoom {
  Finding* next = nullptr;
  Finding* limit = nullptr;
  /// Called when the room has less than a block's width left; false ends the search.
  bool (*make_room)(FoundRoom& room) = nullptr;
  /// Whether the box in this slot is one to be found: asked where the test is not sure, which `find_overlaps`
  /// always is.
  bool (*confirm)(FoundRoom& room, std::uint32_t slot) = nullptr;
};

/// A hit as a number: the bits of t are the upper half, the object the lower one. Such numbers are ordered as
/// hits are, since no t is negative.
using HitNumber = std::uint64_t;

/// Finds all objects whose boxes overlap the region.
template <int D>
void find_overlaps(const BlockView<D>& view, const Box<D>& region, FoundRoom<std::uint32_t>& room);

/// Finds all objects of which the test is sure, or which are confirmed.
template <int D, class Test>
void find_possible(const BlockView<D>& view, const Test& test, FoundRoom<std::uint32_t>& room);

/// The same with the t of each, as `entry_of` has it: 0 or the largest quotient of the axes in doubles, then
/// rounded to a float that is finite.
template <int D>
void find_hits(const BlockView<D>& view, const CastTest<D>& test, FoundRoom<HitNumber>& room);

/// A slot of a block, and whether the caller must confirm its box.
using SlotCode = std::uint32_t;
constexpr std::uint32_t slot_of(SlotCode code) { return code >> 1U; }
constexpr bool is_doubtful(SlotCode code) { return (code & 1U) != 0; }

/// Looks at objects, nearest first.
struct NearRoom {
  /// Is given a slot; returns the bound from now on: objects that are farther are of no interest.
  Scalar (*consider)(NearRoom& room, SlotCode code) = nullptr;
  Scalar bound = 0;
};

/// Calls `consider` with objects in about the order of t, or of squared distance, as long as they are within
/// the bound. For CastTest and BallTest.
template <int D, class Test>
void find_near(const BlockView<D>& view, const Test& test, NearRoom& room);

}  // namespace kerf
