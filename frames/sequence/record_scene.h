#pragma once

#include <cstdint>

#include "frames/sequence/render_request.h"

namespace kerf {

/// Whether a recording's cost is printed; of one that is soon thrown away it is of no use.
enum class CostOfRecording : std::uint8_t { printed, silent };

/// Runs the request's scene for its steps and records it into `request.record`. Throws UsageError,
/// Interrupted (the steps so far are kept), or std::runtime_error if the file cannot be written.
void record_scene(const RenderRequest& request, CostOfRecording cost = CostOfRecording::printed);

}  // namespace kerf
