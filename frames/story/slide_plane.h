#pragma once

#include "frames/story/story_course.h"
#include "viz/draw/frame_planner.h"

namespace kerf {

/// Changes the plan of the moment's step so that its operator is on the way, from 0 (before it) to 1: the
/// plane of a balance slides from its old place to its new one, that of a split grows, that of a merge or
/// swap shrinks. The tree is otherwise as it was after the step.
template <int D>
void slide_plane(FramePlan<D>& plan, const StoryMoment& moment, double progress);

}  // namespace kerf
