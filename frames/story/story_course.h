#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/base/given_names.h"
#include "core/trace/event.h"
#include "frames/sequence/render_request.h"
#include "viz/draw/story.h"

namespace kerf {

/// An operator that acted.
struct StoryMoment {
  std::uint32_t step = 0;
  std::uint64_t event = 0;
  OperatorActed acted;
};

/// What a story has to know of a whole run before its first picture.
struct StoryCourse {
  GivenNames names;                    ///< of the steps
  std::vector<StoryCurve> curves;      ///< each pair of objects, the other broad phase, the tree
  std::vector<StoryMoment> operators;  ///< of the steps that are shown
  std::uint32_t levels = 1;            ///< the most that the tree has
};

/// Replays the recording up to the last step, with a second broad phase beside it: "loose-octree",
/// "sweep-and-prune" or "none". `go_on` is called with each step; false ends it early.
StoryCourse follow_course(const std::filesystem::path& recording, const StepRange& steps,
                          const std::string& beside, const std::function<bool(std::uint32_t)>& go_on);

/// The names that `follow_course` takes.
std::vector<std::string> broad_phases_beside();

/// At most `count` operators that are worth a stop, by their steps: the largest of each kind first, then
/// those of the largest nodes, none nearer to another than half of the steps' fair share.
std::vector<StoryMoment> choose_moments(const std::vector<StoryMoment>& operators, const StepRange& steps,
                                        std::size_t count);

}  // namespace kerf
