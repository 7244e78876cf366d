#pragma once

#include <cstdint>

namespace kerf {

/// The pending flags of an object: what the next step, or the next request, must know of it beside its box.
/// An object without flags is placed and rests in the tree as it is, so that its next move may be taken by a
/// kernel without another look.
using ObjectFlags = std::uint8_t;

namespace flag {

/// Its box or its fat box changes in this step: it is in the list of changed objects. Kernels set this bit.
inline constexpr ObjectFlags kChanged = 1;
/// It is absent or in quarantine: the tree has no entries of it.
inline constexpr ObjectFlags kUnplaced = 2;
/// It is in the list of changed objects though it was not moved: the fat box of its last flight is too large.
inline constexpr ObjectFlags kWrapAnew = 4;
/// It is in the list of changed objects, and was restless before this step.
inline constexpr ObjectFlags kWasRestless = 8;
/// It is in the list of changed objects though it was not moved: it rests, and loses its fat.
inline constexpr ObjectFlags kAtRest = 16;
/// It is in the list of changed objects, and its entries are not in the leaves that its box reaches: the
/// origin was moved (see ShiftPass). Without kChanged its fat box is right already.
inline constexpr ObjectFlags kMisplaced = 32;
/// Its moves request nothing: its box is taken, and the tree follows it by itself. Restless objects have this
/// bit while pairs are kept.
inline constexpr ObjectFlags kUnrequested = 64;
/// Within one call: a request for it was left to the caller, so that later ones must be left, too. The caller
/// clears this bit.
inline constexpr ObjectFlags kDeferred = 128;

}  // namespace flag
}  // namespace kerf
