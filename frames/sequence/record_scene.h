#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>

#include "frames/sequence/render_request.h"

namespace kerf {

/// Whether a recording's cost is printed; of one that is soon thrown away it is of no use.
enum class CostOfRecording : std::uint8_t { printed, silent };

/// What who watches a recording wants of it.
enum class RecordingWish : std::uint8_t {
  more,
  enough,  ///< the steps so far are the recording
  none,    ///< as if interrupted
};
/// Called after each step.
using RecordingWatch = std::function<RecordingWish(std::uint32_t step)>;

/// Runs the request's scene for its steps and records it into `request.record`. Returns where the recording
/// is: one with fewer steps does not replace an earlier one. Throws UsageError, Interrupted (the steps so far
/// are kept), or std::runtime_error if the file cannot be written (PartRecording::write).
std::filesystem::path record_scene(const RenderRequest& request,
                                   CostOfRecording cost = CostOfRecording::printed,
                                   const RecordingWatch& watch = {});

}  // namespace kerf
