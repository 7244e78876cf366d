#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "core/objects/broad_phase.h"

namespace kerf {

/// Data that some libraries need before the first box, because they cannot grow or adapt.
template <int D>
struct RivalHints {
  Box<D> bounds;        ///< where the objects are; the library decides what becomes of objects outside
  Scalar box_size = 1;  ///< a usual extent of a box: the cell size of grids
  std::uint32_t capacity = 1024;                     ///< most objects at a time
  std::array<bool, 3> separating{true, true, true};  ///< axes along which objects are separated
  /// Whether the rival may find its fastest way by the clock, so that no two runs build the same structure.
  bool may_try = false;
};

/// Which boxes a rival gets.
enum class Intake : std::uint8_t {
  checked,  ///< as in ObjectTable: without NaN and min > max, infinities clamped
  raw,      ///< every box as given, to show how the library handles it
};

/// Another library's broad phase behind our interface. It reports each closed overlap that the library finds,
/// except pairs of two fixed objects. Where the library reports only candidates (fat or quantised boxes,
/// cells of a grid), they are filtered by the boxes given; what the library calls an overlap is passed on
/// unfiltered.
template <int D>
struct Rival {
  std::string_view name;  ///< for example "bullet-dbvt"
  std::string_view what;  ///< the library's own name for it
  bool flat = false;      ///< a 3D library that gets 2D boxes as slabs of unit thickness
  std::unique_ptr<BroadPhase<D>> (*make)(const RivalHints<D>& hints, Intake intake) = nullptr;
};

/// All of them, those made for D dimensions first.
template <int D>
std::span<const Rival<D>> rivals();

/// A broad phase with a library that does only part of the work: it leaves candidates to be tested, or keeps
/// pairs that the caller has to visit. The rest of a step is the library's own cost.
class AddedWork {
 public:
  AddedWork() = default;
  AddedWork(const AddedWork&) = delete;
  AddedWork& operator=(const AddedWork&) = delete;
  virtual ~AddedWork() = default;

  /// Completes the answer of the last step once more, with the same pairs, and returns the time of that.
  /// Setting boxes counts for the library. A step itself reads no clock: on small scenes that would be a good
  /// part of its time.
  virtual std::uint64_t time_added() = 0;
};

}  // namespace kerf
