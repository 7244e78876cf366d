#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "core/objects/broad_phase.h"

namespace kerf {

/// What some libraries ask before the first box, because they cannot grow or adapt.
template <int D>
struct RivalHints {
  Box<D> bounds;                  ///< where the objects are; what leaves it is the library's affair
  Scalar box_size = 1;            ///< a usual extent of a box: the cell size of grids
  std::uint32_t capacity = 1024;  ///< most objects at a time
  std::array<bool, 3> separating{true, true, true};  ///< axes along which objects are told apart
};

/// What a rival is given to see.
enum class Intake : std::uint8_t {
  checked,  ///< as ObjectTable has it: NaN and min > max withheld, infinities clamped
  raw,      ///< every box as it comes, so that the library shows what it makes of it
};

/// Another library's broad phase behind our interface. It tells each closed overlap that the library finds,
/// two fixed objects excepted. Where the library tells candidates only (fat or quantised boxes, cells of a
/// grid), they are filtered by the boxes given; what it calls an overlap is passed on as told.
template <int D>
struct Rival {
  std::string_view name;  ///< for example "bullet-dbvt"
  std::string_view what;  ///< the library's name of it
  bool flat = false;      ///< a 3D library that is shown 2D boxes as slabs of unit thickness
  std::unique_ptr<BroadPhase<D>> (*make)(const RivalHints<D>& hints, Intake intake) = nullptr;
};

/// All of them, those made for D dimensions first.
template <int D>
std::span<const Rival<D>> rivals();

template <int D>
std::optional<Rival<D>> find_rival(std::string_view name);

}  // namespace kerf
