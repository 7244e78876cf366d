#pragma once

#include <string>
#include <string_view>

namespace kerf {

/// Width and height of a picture in pixels.
struct PictureSize {
  int width = 1280;
  int height = 720;
  friend bool operator==(const PictureSize&, const PictureSize&) = default;
};

/// Throws UsageError, beginning with `given`, for sides that no frame can have (kMinFrameSide to
/// kMaxFrameSide).
void check(const PictureSize& size, const std::string& given);

/// Reads "1280x720". Throws UsageError for anything else, and as `check` does.
PictureSize parse_picture_size(std::string_view text);

}  // namespace kerf
