#include "frames/sequence/contact_strip.h"

#include <algorithm>

#include "viz/image/contact_sheet.h"
#include "viz/image/png.h"

namespace kerf {
namespace {

constexpr std::uint32_t kThumbs = 20;
constexpr int kColumns = 4;
constexpr int kThumbWidth = 640;

}  // namespace

/// The chosen ones are round(k * (frames - 1) / (kThumbs - 1)): the first and the last are among them.
bool ContactStrip::is_chosen(std::uint32_t index) const {
  if (frames_ <= kThumbs) return true;
  const std::uint64_t span = frames_ - 1;
  const std::uint64_t k = (std::uint64_t{index} * (kThumbs - 1) + span / 2) / span;
  return (k * span + (kThumbs - 1) / 2) / (kThumbs - 1) == index;
}

void ContactStrip::offer(std::uint32_t index, const Image& image) {
  if (!is_chosen(index)) return;
  const int width = std::min(kThumbWidth, image.width);
  thumbs_.push_back(downscale(image, width, std::max(1, image.height * width / image.width)));
}

void ContactStrip::save(const std::filesystem::path& path, Replace replace) const {
  write_png(path, contact_sheet(thumbs_, std::min(kColumns, static_cast<int>(thumbs_.size()))), replace);
}

}  // namespace kerf
