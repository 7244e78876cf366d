#pragma once

#include "frames/sequence/render_request.h"

namespace kerf {

/// Renders a whole frame sequence: PNG files, manifest and, if requested, film and contact sheet.
///
/// The manifest is written last and names only frames that are there; it is also written, marked incomplete,
/// when the work is interrupted or fails. Throws UsageError before any file is touched, Interrupted after
/// SIGINT or SIGTERM, std::runtime_error for everything that the machine refuses.
void render_sequence(const RenderRequest& request);

}  // namespace kerf
