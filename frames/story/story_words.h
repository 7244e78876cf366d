#pragma once

#include <cstdint>

#include "core/base/given_names.h"
#include "frames/story/story_maker.h"
#include "viz/draw/frame_planner.h"

namespace kerf {

/// The sentence of a picture and the node that it is about: the operator of the moment at which time stands
/// still, else the newest that has not faded; of none nothing is said.
template <int D>
void tell_operator(const FramePlan<D>& plan, std::uint32_t step, const GivenNames& names,
                   StoryInsert& insert);

}  // namespace kerf
