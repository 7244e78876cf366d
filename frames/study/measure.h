#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include "core/files/part_file.h"
#include "frames/sequence/manifest.h"
#include "frames/study/study.h"

namespace kerf {

/// The figures of a cell. The same settings give the same counts on each machine; times differ.
struct Figures {
  Json counts = Json::object();
  Json times = Json::object();
};

/// Figures of a broad phase. Times are milliseconds a step, the mean of the measured steps: "total_ms", and
/// where the broad phase knows them "overhead_ms" (taking over the boxes, and bringing the structure up to
/// date) and "collision_ms" (finding the pairs); "median_ms" and "worst_ms" are of whole steps. Counts are
/// "pairs" and "candidates" in all measured steps, "pairs_hash" of all pairs in the order of the steps,
/// "missed" and "extra" beside the oracle, and, after the last step, "bodies", "leaves", "height", "entries"
/// and "operators" (acted since the beginning). Times are taken in a run of their own. Nothing is written.
Figures measure(const RunCell& cell, const std::filesystem::path& folder, Replace replace);

/// The oracle of "missed" and "extra": tests each object against each, or sweeps where that would take too
/// long. It is never the broad phase that it judges.
std::string_view oracle_for(std::uint32_t objects, std::string_view broad_phase);

/// Renders into `folder`. Frames of an earlier attempt are kept, or with Replace::earlier drawn anew. Counts
/// are "frames" and "pixels_hash", times are "total_ms".
Figures measure(const FramesCell& cell, const std::filesystem::path& folder, Replace replace);

/// "frames" and "pixels_hash", as a manifest has them.
Json counts_of(const Manifest& manifest);

}  // namespace kerf
