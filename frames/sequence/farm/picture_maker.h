#pragma once

#include "frames/sequence/farm/frame_order.h"
#include "frames/sequence/render_request.h"

namespace kerf {

/// Draws the frames of a request into its folder. GL starts here. Throws UsageError for an impossible camera
/// or size, std::runtime_error if drawing fails.
std::unique_ptr<FrameMaker> make_picture_maker(const RenderRequest& request);

}  // namespace kerf
