#pragma once

#include <optional>
#include <string>
#include <vector>

#include "frames/diff/frame_pairs.h"
#include "viz/image/compare.h"
#include "viz/image/flip.h"

namespace kerf {

/// The condition for two pictures to count as the same.
enum class DiffGate {
  automatic,  ///< exact, unless the draw lists name two rasterisers: then flip
  exact,      ///< every pixel: for pictures of one rasteriser
  ids,        ///< draw list and id image: the same things at the same place in the same colours
  flip,       ///< invisible to a person: FLIP's maximum, and ids where they are; for two rasterisers
};

/// The largest maximum of FLIP that the gate `flip` accepts: two rasterisers of Mesa reach 0.35
/// (docs/IMAGE_DIFF.md).
inline constexpr double kFlipLimit = 0.45;

struct DiffRules {
  DiffGate gate = DiffGate::automatic;
  double flip_limit = kFlipLimit;
};

/// The result for one pair of pictures.
struct FrameDiff {
  FramePair frame;
  std::string trouble;  ///< why they cannot be compared; empty: they were
  bool same = false;    ///< by the gate
  PixelComparison pixels;
  std::uint64_t different_lower = 0;  ///< pixels that differ in the lower 8 of 16 bits alone
  DiffGate gate = DiffGate::exact;    ///< that decided
  std::vector<std::string> drawn;     ///< what has changed in words; known if both have ids
  std::optional<FlipSummary> flip;    ///< if any pixel differs
  std::vector<std::string> reasons;   ///< what the gate objects to, one line each
};

/// Compares two pictures; never throws for faults of their files: those go into `trouble`.
FrameDiff diff_frame(const FramePair& frame, const DiffRules& rules);

/// "auto", "exact", "ids", "flip"
std::string_view to_string(DiffGate gate);
inline constexpr DiffGate kDiffGates[] = {DiffGate::automatic, DiffGate::exact, DiffGate::ids,
                                          DiffGate::flip};

}  // namespace kerf
