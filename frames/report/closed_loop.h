#pragma once

#include <cstdint>
#include <string_view>

#include "frames/page/cell.h"
#include "frames/report/take.h"

namespace kerf {

/// Runs a scene in which the pairs decide the motion, from one seed: with the exact broad phase, as the
/// reference, and once more; with the paper's, which reports the same pairs; with the first object moved
/// aside by one ulp (the control, which shows how chaotic the scene itself is); and with each of
/// `few_settings()`.
///
/// {"steps": [...], "runs": [{"setting", "family", "mean_ns" (of the broad phase, an object and step),
/// "distance": [...], "energy": [...], "depth": [...]}, ...]}: at each of the steps how far objects are from
/// their positions in the exact run (root of the mean square, units of the scene), the height of energy, and
/// the deepest penetration.
template <int D>
Json run_closed_loops(std::string_view scene, const SceneLength& length, std::uint64_t seed,
                      const Poll& poll);

}  // namespace kerf
