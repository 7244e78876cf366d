#pragma once

#include "frames/sequence/render_request.h"

namespace kerf {

/// Runs the request's scene for its steps and records it into `request.record`; prints the cost. Throws
/// UsageError, Interrupted (the steps so far are kept), or std::runtime_error if the file cannot be written.
void record_scene(const RenderRequest& request);

}  // namespace kerf
