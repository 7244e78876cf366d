#include "frames/support/picture_size.h"

#include "frames/support/errors.h"
#include "frames/support/parse_number.h"
#include "viz/draw/frame_renderer.h"

namespace kerf {

void check(const PictureSize& size, const std::string& given) {
  const auto fits = [](int side) { return side >= kMinFrameSide && side <= kMaxFrameSide; };
  if (fits(size.width) && fits(size.height)) return;
  throw UsageError(given + " is out of range: width and height go from " + std::to_string(kMinFrameSide) +
                   " to " + std::to_string(kMaxFrameSide) + " pixels");
}

PictureSize parse_picture_size(std::string_view text) {
  const std::string given = "--size '" + std::string(text) + "'";
  const std::size_t x = text.find_first_of("xX");
  const auto width = parse_number<int>(text.substr(0, x));
  const auto height = x == std::string_view::npos ? std::nullopt : parse_number<int>(text.substr(x + 1));
  if (!width || !height) throw UsageError(given + " is not WIDTHxHEIGHT in pixels, for example 1280x720");
  const PictureSize size{*width, *height};
  check(size, given);
  return size;
}

}  // namespace kerf
