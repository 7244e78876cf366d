#pragma once

#include <cmath>
#include <cstdint>

#include "core/geometry/denormal.h"
#include "core/geometry/vector.h"

namespace kerf {

/// What an object is to the program. It decides which pairs are reported: those in which at least one object
/// is `moving` or a `sensor`, as in Box2D.
enum class ObjectKind : std::uint8_t {
  fixed,      ///< static: part of the level. It may still be moved, as an editor does.
  kinematic,  ///< moved by the program and by nothing else: a lift, a door
  moving,     ///< dynamic: moved by contacts
  sensor,     ///< notices objects of every kind, other sensors included; its pairs are flagged
};
inline constexpr int kObjectKinds = 4;

/// Whether two objects of such kinds are never a pair.
constexpr bool is_passive(ObjectKind kind) {
  return kind == ObjectKind::fixed || kind == ObjectKind::kinematic;
}

/// Which objects may form pairs: Box2D's rule. Two objects of one group other than 0 form a pair if the group
/// is positive, and none if it is negative. All others form a pair if the category of each has a bit in the
/// other's mask.
struct PairFilter {
  std::uint64_t category = 1;
  std::uint64_t mask = UINT64_MAX;
  std::int32_t group = 0;
  friend constexpr bool operator==(const PairFilter&, const PairFilter&) = default;
};

constexpr bool may_pair(const PairFilter& a, const PairFilter& b) {
  if (a.group != 0 && a.group == b.group) return a.group > 0;
  return (a.mask & b.category) != 0 && (b.mask & a.category) != 0;
}

// Whether an object may have it as its margin, and whether it is one: denormals count, also where the
// processor takes them for zero.
inline bool is_margin(Scalar margin) { return std::isfinite(margin) && wide(margin) >= 0; }
constexpr bool is_thick(Scalar margin) { return wide(margin) > 0; }

/// Everything of an object but its box.
struct ObjectDef {
  ObjectKind kind = ObjectKind::moving;
  /// Thickness of the skin of its fat box, in units of length: finite, not negative. The fat box is made
  /// when the object is inserted and each time that its box leaves it: the box, larger by the margin on
  /// every side. 0: the fat box is the box.
  Scalar margin = 0;
  PairFilter filter;
  std::uint64_t user_data = 0;  ///< of the caller's; the world only keeps it
  friend constexpr bool operator==(const ObjectDef&, const ObjectDef&) = default;
};

}  // namespace kerf
