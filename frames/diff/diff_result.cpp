#include "frames/diff/diff_result.h"

#include <algorithm>

#include "core/base/counted.h"
#include "frames/page/json.h"
#include "frames/support/printed.h"

namespace kerf {
namespace {

constexpr std::size_t kShownReasons = 24;

std::string color_text(const std::array<std::uint8_t, 4>& c) {
  return printed(c[3] == 255 ? "#%02x%02x%02x" : "#%02x%02x%02x%02x", c[0], c[1], c[2], c[3]);
}

std::string first_pixels(const PixelComparison& pixels) {
  std::string text = "first:";
  for (const DifferentPixel& pixel : pixels.first) {
    text += (text.ends_with(':') ? " (" : ", (") + std::to_string(pixel.x) + ", " + std::to_string(pixel.y) +
            ") " + color_text(pixel.a) + " -> " + color_text(pixel.b);
  }
  return text;
}

std::string flip_figures(const FlipSummary& flip) {
  std::string text = printed("FLIP: largest %.4f, mean %.6f; worst at", flip.max, flip.mean);
  for (const FlipPixel& pixel : flip.worst) text += printed(" (%d, %d) %.3f", pixel.x, pixel.y, pixel.error);
  return text;
}

std::string frame_text(const FrameDiff& diff) {
  if (!diff.trouble.empty()) return diff.frame.name + ": " + diff.trouble + "\n";
  if (diff.same) return "";
  std::string text = diff.frame.name + ":";
  const bool single = diff.reasons.size() == 1;
  const std::size_t shown = std::min(diff.reasons.size(), kShownReasons);
  for (std::size_t i = 0; i < shown; ++i) text += (single ? " " : "\n  ") + diff.reasons[i];
  if (shown < diff.reasons.size())
    text += "\n  and " + std::to_string(diff.reasons.size() - shown) + " more; --json has them all";
  text += "\n";
  if (!diff.pixels.first.empty()) text += "  " + first_pixels(diff.pixels) + "\n";
  if (diff.flip) text += "  " + flip_figures(*diff.flip) + "\n";
  return text;
}

Json pixels_json(const PixelComparison& pixels) {
  Json first = Json::array();
  for (const DifferentPixel& pixel : pixels.first)
    first.push_back(
        {{"x", pixel.x}, {"y", pixel.y}, {"reference", color_text(pixel.a)}, {"test", color_text(pixel.b)}});
  const PixelBounds& bounds = pixels.bounds;
  return {{"different", pixels.different},
          {"largest_step", pixels.largest_step},
          {"left", bounds.left},
          {"top", bounds.top},
          {"right", bounds.right},
          {"bottom", bounds.bottom},
          {"first", first}};
}

Json flip_json(const FlipSummary& flip) {
  Json worst = Json::array();
  for (const FlipPixel& pixel : flip.worst)
    worst.push_back({{"x", pixel.x}, {"y", pixel.y}, {"error", pixel.error}});
  return {{"max", flip.max}, {"mean", flip.mean}, {"worst", worst}};
}

Json frame_json(const FrameDiff& diff) {
  const char* verdict = !diff.trouble.empty()     ? "unusable"
                        : diff.same               ? "same"
                        : diff.frame.is_missing() ? "missing"
                        : diff.frame.is_extra()   ? "extra"
                                                  : "different";
  Json json{{"name", diff.frame.name},
            {"verdict", verdict},
            {"reference", diff.frame.reference.string()},
            {"test", diff.frame.test.string()}};
  if (!diff.trouble.empty()) json["trouble"] = diff.trouble;
  json["gate"] = to_string(diff.gate);
  json["reasons"] = diff.reasons;
  json["drawn"] = diff.drawn;
  json["pixels"] = pixels_json(diff.pixels);
  json["different_lower"] = diff.different_lower;
  if (diff.flip) json["flip"] = flip_json(*diff.flip);
  return json;
}

}  // namespace

std::size_t DiffResult::count_different() const {
  return static_cast<std::size_t>(std::ranges::count_if(
      frames, [](const FrameDiff& diff) { return diff.trouble.empty() && !diff.same; }));
}

std::size_t DiffResult::count_troubled() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(frames, [](const FrameDiff& diff) { return !diff.trouble.empty(); }));
}

std::string summary_line(const DiffResult& result) {
  const auto count = [&](auto what) { return std::to_string(std::ranges::count_if(result.frames, what)); };
  const auto missing = [](const FrameDiff& diff) { return diff.frame.is_missing(); };
  const auto extra = [](const FrameDiff& diff) { return diff.frame.is_extra(); };
  const std::size_t frames = result.frames.size();
  const std::string all = counted(frames, "frame");
  const std::string gate = ", by the gate '" + std::string(to_string(result.rules.gate)) + "'";
  if (result.is_same()) return counted(frames, "frame is", "frames are") + " the same" + gate;
  std::string text;
  if (result.count_troubled() > 0)
    text = std::to_string(result.count_troubled()) + " of " + all + " cannot be compared; ";
  if (!result.faults.empty()) text += "not all that should be there could be compared; ";
  const std::size_t different = result.count_different();
  text += std::to_string(different) + " of " + all + (different == 1 ? " differs" : " differ");
  if (std::ranges::any_of(result.frames, missing)) text += ", " + count(missing) + " of them missing";
  if (std::ranges::any_of(result.frames, extra)) text += ", " + count(extra) + " without a reference";
  if (!result.manifests.empty())
    text += "; " + counted(result.manifests.size(), "manifest differs", "manifests differ");
  return text + gate;
}

std::vector<std::string> manifest_lines(const DiffResult& result) {
  std::vector<std::string> lines;
  for (const ManifestDiff& manifest : result.manifests)
    for (const std::string& reason : manifest.reasons) lines.push_back(manifest.name + ": " + reason);
  return lines;
}

std::string to_text(const DiffResult& result) {
  std::string text;
  for (const std::string& note : result.notes) text += "note: " + note + "\n";
  for (const std::string& fault : result.faults) text += fault + "\n";
  for (const std::string& line : manifest_lines(result)) text += line + "\n";
  for (const FrameDiff& diff : result.frames) text += frame_text(diff);
  return result.is_same() ? text + summary_line(result) + "\n" : text;
}

std::string to_json(const DiffResult& result) {
  Json json{{"format", "kerf-diff-1"},
            {"reference", result.reference.string()},
            {"test", result.test.string()},
            {"gate", to_string(result.rules.gate)},
            {"flip_limit", result.rules.flip_limit},
            {"same", result.is_same()},
            {"usable", result.is_usable()},
            {"different", result.count_different()},
            {"notes", result.notes},
            {"faults", result.faults},
            {"manifests", manifest_lines(result)},
            {"frames", Json::array()}};
  for (const FrameDiff& diff : result.frames) json["frames"].push_back(frame_json(diff));
  return json_text(json) + "\n";
}

}  // namespace kerf
