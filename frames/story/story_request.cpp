#include "frames/story/story_request.h"

#include <algorithm>
#include <sstream>

#include "frames/story/story_course.h"
#include "frames/support/errors.h"
#include "frames/support/parse_number.h"
#include "frames/support/suggest.h"

namespace kerf {
namespace {

constexpr const char* kStoryLayers = "none,+objects,+leaves,+partitioners,+operators";
constexpr std::uint32_t kSecondsForMoment = 8;
constexpr double kSecondsOfMoment = 2.5;
constexpr int kLeastWidth = 640;
constexpr int kLeastHeight = 360;

RenderTexts with_defaults(RenderTexts texts) {
  if (texts.steps.empty() && !names_recording(texts)) texts.steps = "800";
  if (texts.size.empty()) texts.size = "1920x1080";
  if (texts.fps.empty()) texts.fps = "60";
  if (texts.show.empty() || texts.show.starts_with('+') || texts.show.starts_with('-'))
    texts.show = kStoryLayers + (texts.show.empty() ? "" : "," + texts.show);
  return texts;
}

/// "all" means all that there is.
void refuse_words(const std::string& layers) {
  std::istringstream list(layers);
  for (std::string layer; std::getline(list, layer, ',');)
    for (const char* const words : {"caption", "legend"})
      if (layer == words || layer == std::string("+") + words)
        throw UsageError(std::string("--show ") + words +
                         ": a film has a title and curves in its place; leave that layer out");
}

std::string parse_beside(const std::string& text) {
  const std::vector<std::string> names = broad_phases_beside();
  if (text.empty()) return names.front();
  if (std::ranges::find(names, text) == names.end())
    throw UsageError("--beside: " + unknown_name_message("broad phase that counts its tests", text, names));
  return text;
}

}  // namespace

StoryRequest parse_story_request(const StoryTexts& texts) {
  refuse_words(texts.pictures.show);
  const RenderTexts pictures = with_defaults(texts.pictures);
  StoryRequest request;
  request.pictures = names_recording(pictures) ? parse_recording_request(pictures) : parse_request(pictures);
  RenderRequest& render = request.pictures;
  if (!render.broad_phase.is_tree())
    throw UsageError("--broad-phase: the film is of a tree; give kerf-paper or kerf");
  if (render.size.width < kLeastWidth || render.size.height < kLeastHeight)
    throw UsageError("--size: icicle and curves need 640x360 pixels or more");
  if (render.steps.first == render.steps.last) throw UsageError("--steps: a film needs two steps or more");
  render.steps.stride = 1;
  render.layers = render.layers.with(Layer::caption, false).with(Layer::legend, false);
  std::uint32_t seconds = 60;
  if (!texts.seconds.empty()) seconds = parse_whole<std::uint32_t>("--seconds", texts.seconds, 2, 3600);
  request.frames = seconds * static_cast<std::uint32_t>(render.film.fps);
  request.moments = std::max(1U, seconds / kSecondsForMoment);
  request.hold = static_cast<std::uint32_t>(kSecondsOfMoment * render.film.fps);
  request.beside = parse_beside(texts.beside);
  request.still = texts.still;
  return request;
}

}  // namespace kerf
