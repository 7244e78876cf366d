#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "frames/sequence/render_request.h"

namespace kerf {

/// The options of `kerf film` as the user typed them; empty: not given.
struct StoryTexts {
  RenderTexts pictures;
  std::string seconds;
  std::string beside;
  std::string still;
};

/// What to show, every part of it checked.
struct StoryRequest {
  RenderRequest pictures;  ///< its film is the story
  std::uint32_t frames = 3600;
  std::uint32_t moments = 7;    ///< at most
  std::uint32_t hold = 150;     ///< pictures of a moment
  std::string beside;           ///< the second broad phase, or "none"
  std::filesystem::path still;  ///< a picture of the largest moment; empty: none
};

/// Throws UsageError that says what to do, and as the parsers of `kerf render` do.
StoryRequest parse_story_request(const StoryTexts& texts);

}  // namespace kerf
