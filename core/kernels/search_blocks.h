#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/geometry/box.h"
#include "core/kernels/wide_block.h"

namespace kerf {

// What kernels ask of eight boxes at once. The floats err on the side of "possible"; where they cannot be
// sure, the caller must look at the box itself.

/// A cast: on each axis a box is met first with its near end, left with its far end.
template <int D>
struct CastTest {
  std::array<Scalar, D> near_start{};   ///< the end of the moving box that meets the near end, at t = 0
  std::array<Scalar, D> far_start{};    ///< the end that leaves the far end
  std::array<Scalar, D> near_factor{};  ///< 1 / direction, smaller by more than all roundings
  std::array<Scalar, D> far_factor{};   ///< larger
  std::array<double, D> direction{};    ///< if it is 0 the ends must be on their sides for all t
  bool moves_on_all = true;             ///< no direction is 0
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
  /// Whether the box in this slot is one to be found: asked where floats cannot be sure. Not of regions of
  /// boxes.
  bool (*confirm)(FoundRoom& room, std::uint32_t slot) = nullptr;
};

/// A hit as a number: t above the object, both as bits. Those of floats that are not negative grow with them.
using HitNumber = std::uint64_t;

/// Finds all objects whose boxes overlap the region.
template <int D>
void find_overlaps(const BlockView<D>& view, const Box<D>& region, FoundRoom<std::uint32_t>& room);

/// Finds all objects of which the test is sure, or which are confirmed.
template <int D, class Test>
void find_possible(const BlockView<D>& view, const Test& test, FoundRoom<std::uint32_t>& room);

/// The same with the t of each: the largest quotient of the axes, in doubles, and 0 at least.
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
