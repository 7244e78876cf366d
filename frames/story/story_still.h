#pragma once

#include <cstdint>
#include <span>

#include "frames/story/story_course.h"
#include "frames/story/story_timeline.h"

namespace kerf {

/// The frame that is the picture of a film: where the plane of the moment with the most objects is half on
/// its way. In a film too short to stand still at a moment, it is the first frame behind the operator with
/// the most objects; without operators the one in the middle. `hold`: frames for which time stands still.
std::uint32_t frame_of_still(std::span<const StoryFrame> frames, std::span<const StoryMoment> moments,
                             std::span<const StoryMoment> operators, std::uint32_t hold);

}  // namespace kerf
