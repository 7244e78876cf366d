#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "frames/sequence/farm/frame_order.h"
#include "frames/story/story_course.h"
#include "frames/story/story_request.h"

namespace kerf {

/// What a picture of a story shows beside the frame of its scene.
struct StoryInsert {
  std::string title;
  std::string figures;
  std::string sentence;
  std::optional<NodeId> acting;
  std::optional<StoryMoment> moment;  ///< time stands still there
  double progress = 0;                ///< of the moment
  double turn = 0;                    ///< degrees that the camera has turned
  std::uint32_t step = 1;
  std::array<std::string, 2> ends;  ///< the names of the first and the last step
  std::uint32_t levels = 1;
  std::vector<StoryCurve> curves;
};

/// Serialises it before a frame of `pack`.
std::vector<std::uint8_t> pack_story(const StoryInsert& insert, const std::vector<std::uint8_t>& frame);

/// Draws the pictures of a story, and writes no files. GL starts here. Throws as `make_picture_maker` does.
std::unique_ptr<FrameMaker> make_story_maker(const StoryRequest& request);

}  // namespace kerf
