#pragma once

#include "frames/story/story_request.h"

namespace kerf {

/// Makes the film of a story: the run is looked at once for its moments and counts, and then drawn. Throws
/// UsageError, Interrupted (no film is made), or std::runtime_error if there can be no film.
void make_story(const StoryRequest& request);

}  // namespace kerf
