#include "frames/diff/frame_diff.h"

#include <cstdio>
#include <stdexcept>

#include "viz/image/png.h"

namespace kerf {
namespace {

std::string size_text(const Image& image) {
  return std::to_string(image.width) + "x" + std::to_string(image.height);
}

std::string pixels_text(const PixelComparison& pixels, const Image& image) {
  const PixelBounds& bounds = pixels.bounds;
  char text[200];
  std::snprintf(text, sizeof text, "%llu of %llu pixels differ, within %dx%d at (%d, %d), by up to %d of 255",
                static_cast<unsigned long long>(pixels.different),
                static_cast<unsigned long long>(image.rgba.size() / 4), bounds.right - bounds.left,
                bounds.bottom - bounds.top, bounds.left, bounds.top, pixels.largest_step);
  return text;
}

std::string flip_text(const FlipSummary& flip, double limit) {
  char text[120];
  std::snprintf(text, sizeof text, "FLIP is %.3f at (%d, %d), and %.3f is allowed", flip.max,
                flip.worst.front().x, flip.worst.front().y, limit);
  return text;
}

void compare(const Image& reference, const Image& test, const DiffRules& rules, FrameDiff& diff) {
  if (reference.width != test.width || reference.height != test.height) {
    diff.trouble = "they are of different sizes: " + size_text(reference) + " and " + size_text(test);
    return;
  }
  diff.pixels = compare_pixels(reference, test);
  if (diff.pixels.same()) {
    diff.same = true;
    return;
  }
  diff.flip = summarize_flip(flip_errors(reference, test));
  if (rules.gate == DiffGate::exact) {
    diff.reasons.push_back(pixels_text(diff.pixels, test));
  } else if (diff.flip->max > rules.flip_limit) {
    diff.reasons.push_back(flip_text(*diff.flip, rules.flip_limit));
  }
  diff.same = diff.reasons.empty();
}

}  // namespace

FrameDiff diff_frame(const FramePair& frame, const DiffRules& rules) {
  FrameDiff diff;
  diff.frame = frame;
  try {
    if (frame.is_missing()) {
      diff.reasons = {"it is missing"};
    } else if (frame.is_extra()) {
      diff.reasons = {"it has no reference"};
    } else {
      compare(read_png(frame.reference), read_png(frame.test), rules, diff);
    }
  } catch (const std::runtime_error& error) {
    diff.trouble = error.what();
  }
  return diff;
}

std::string_view to_string(DiffGate gate) { return gate == DiffGate::exact ? "exact" : "flip"; }

}  // namespace kerf
