#include "frames/diff/frame_diff.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include "core/base/counted.h"
#include "core/files/whole_file.h"
#include "frames/sequence/draw_list_file.h"
#include "frames/sequence/sidecar.h"
#include "frames/support/printed.h"
#include "viz/draw/compare_drawn.h"
#include "viz/image/stored_picture.h"

namespace kerf {
namespace {

std::string size_text(const Image& image) {
  return std::to_string(image.width) + "x" + std::to_string(image.height);
}

/// "3 of 400 pixels differ"
std::string differ_text(std::uint64_t different, const Image& image) {
  return std::to_string(different) + " of " + counted(image.rgba.size() / 4, "pixel") +
         (different == 1 ? " differs" : " differ");
}

std::string pixels_text(const PixelComparison& pixels, const Image& image) {
  const PixelBounds& bounds = pixels.bounds;
  return differ_text(pixels.different, image) +
         printed(", within %dx%d at (%d, %d), by up to %d of 255", bounds.right - bounds.left,
                 bounds.bottom - bounds.top, bounds.left, bounds.top, pixels.largest_step);
}

std::string lower_text(std::uint64_t different, const Image& image) {
  return differ_text(different, image) + " in the lower 8 of their 16 bits";
}

std::string flip_text(const FlipSummary& flip, double limit) {
  return printed("FLIP is %.3f at (%d, %d), and %.3f is allowed", flip.max, flip.worst.front().x,
                 flip.worst.front().y, limit);
}

/// Ids of both, if both have them.
struct BothIds {
  std::optional<StoredIds> reference;
  std::optional<StoredIds> test;
  [[nodiscard]] bool there() const { return reference && test; }
};

StoredIds checked(StoredIds stored, const Image& image, const std::filesystem::path& frame) {
  if (stored.ids.image.width != image.width || stored.ids.image.height != image.height)
    throw std::runtime_error("the ids of " + frame.string() + " are of another size than the picture");
  return stored;
}

/// None, too, if there is only one of the two files: folders say so themselves.
std::optional<StoredIds> ids_of(const std::filesystem::path& frame, const Image& image) {
  if (!std::filesystem::exists(ids_path(frame)) || !std::filesystem::exists(draw_list_path(frame)))
    return std::nullopt;
  auto stored = read_ids(frame);
  if (stored) stored = checked(std::move(*stored), image, frame);
  return stored;
}

DiffGate choose_gate(DiffGate wanted, const BothIds& ids) {
  if (wanted != DiffGate::automatic) return wanted;
  const bool foreign = ids.there() && ids.reference->rasterizer != ids.test->rasterizer;
  return foreign ? DiffGate::flip : DiffGate::exact;
}

/// FLIP lays both over white, where white and transparent are the same.
int largest_step_of_alpha(const Image& reference, const Image& test) {
  int largest = 0;
  for (std::size_t k = 3; k < test.rgba.size(); k += 4)
    largest = std::max(largest, std::abs(int{reference.rgba[k]} - int{test.rgba[k]}));
  return largest;
}

void judge(const Image& reference, const Image& test, const DiffRules& rules, FrameDiff& diff) {
  if (diff.gate == DiffGate::exact && !diff.pixels.same())
    diff.reasons.push_back(pixels_text(diff.pixels, test));
  if (diff.gate == DiffGate::exact && diff.different_lower > 0)
    diff.reasons.push_back(lower_text(diff.different_lower, test));
  if (diff.gate == DiffGate::flip && diff.flip && diff.flip->max > rules.flip_limit)
    diff.reasons.push_back(flip_text(*diff.flip, rules.flip_limit));
  if (const int step = largest_step_of_alpha(reference, test);
      diff.gate == DiffGate::flip && step > rules.flip_limit * 255)
    diff.reasons.push_back("alpha differs by up to " + std::to_string(step) + " of 255");
  diff.reasons.insert(diff.reasons.end(), diff.drawn.begin(), diff.drawn.end());
  diff.reasons.insert(diff.reasons.end(), diff.frame.beside.begin(), diff.frame.beside.end());
  diff.same = diff.reasons.empty();
}

/// Whether what lies beside the two is the same, byte by byte. False says nothing yet.
bool have_same_ids(const FramePair& frame) {
  const auto is_same = [](const std::filesystem::path& a, const std::filesystem::path& b) {
    const bool there = std::filesystem::exists(a);
    return there == std::filesystem::exists(b) && (!there || read_whole_file(a) == read_whole_file(b));
  };
  return is_same(ids_path(frame.reference), ids_path(frame.test)) &&
         is_same(draw_list_path(frame.reference), draw_list_path(frame.test));
}

/// What forbids to judge by the pixels alone; empty: nothing does.
std::string find_trouble(const StoredPicture& reference, const StoredPicture& test) {
  if (reference.image.width != test.image.width || reference.image.height != test.image.height)
    return "they are of different sizes: " + size_text(reference.image) + " and " + size_text(test.image);
  const std::string chunks = different_chunks(reference, test);
  if (chunks.empty()) return "";
  return "their chunks differ (" + chunks +
         "): they make more of a picture than its pixels say, which is not compared";
}

void compare(const Image& reference, const Image& test, const DiffRules& rules, FrameDiff& diff) {
  diff.pixels = compare_pixels(reference, test);
  BothIds ids;
  const bool pixels_decide = rules.gate == DiffGate::automatic || rules.gate == DiffGate::exact;
  if (!diff.pixels.same() || !pixels_decide || !have_same_ids(diff.frame))
    ids = {ids_of(diff.frame.reference, reference), ids_of(diff.frame.test, test)};
  diff.gate = choose_gate(rules.gate, ids);
  if (diff.gate == DiffGate::ids && !ids.there())
    throw std::runtime_error("there are no ids beside " +
                             (ids.reference ? diff.frame.test : diff.frame.reference).string() +
                             "; draw it with --ids");
  if (ids.there()) diff.drawn = compare_drawn(ids.reference->ids, ids.test->ids);
  if (!diff.pixels.same()) diff.flip = summarize_flip(flip_errors(reference, test));
  judge(reference, test, rules, diff);
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
      const StoredPicture reference = read_stored_picture(frame.reference);
      const StoredPicture test = read_stored_picture(frame.test);
      diff.trouble = find_trouble(reference, test);
      if (!diff.trouble.empty()) return diff;
      diff.different_lower = count_different_lower(reference, test);
      compare(reference.image, test.image, rules, diff);
    }
  } catch (const std::runtime_error& error) {
    diff.trouble = error.what();
  }
  return diff;
}

std::string_view to_string(DiffGate gate) {
  switch (gate) {
    case DiffGate::automatic:
      return "auto";
    case DiffGate::exact:
      return "exact";
    case DiffGate::ids:
      return "ids";
    case DiffGate::flip:
      return "flip";
  }
  return "";
}

}  // namespace kerf
