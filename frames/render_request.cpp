#include "frames/render_request.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "frames/errors.h"
#include "frames/parse_config.h"
#include "frames/parse_number.h"
#include "frames/suggest.h"
#include "frames/video.h"
#include "viz/draw/camera.h"

namespace kerf {
namespace {

template <class Number>
Number number_in(std::string_view option, const std::string& text, Number least, Number most) {
  const auto number = parse_number<Number>(text);
  if (!number || *number < least || *number > most) {
    throw UsageError(std::string(option) + " '" + text + "' is not a whole number from " +
                     std::to_string(least) + " to " + std::to_string(most));
  }
  return *number;
}

/// Runs a parser of another room, whose std::invalid_argument becomes an error of usage.
template <class Parse>
auto parse_option(std::string_view option, Parse parse) {
  try {
    return parse();
  } catch (const std::invalid_argument& error) {
    throw UsageError(std::string(option) + ": " + error.what());
  }
}

void check_camera(const CatalogScene& scene, const std::string& text) {
  parse_option("--camera", [&] {
    if (scene.dimension() == 2) {
      (void)parse_camera<2>(text);
    } else {
      (void)parse_camera<3>(text);
    }
    return 0;
  });
}

void check_picture_extension(const std::filesystem::path& path) {
  if (path.extension() == ".png") return;
  throw UsageError("--contact-sheet '" + path.string() + "': give the file the extension .png");
}

template <int D>
VolumeKind parse_volume(const std::string& text) {
  if (const auto kind = parse_volume_kind<D>(text)) return *kind;
  std::vector<std::string> names;
  for (const VolumeKind kind : volume_kinds<D>()) names.emplace_back(to_string(kind));
  throw UsageError("--volume: " + unknown_name_message("volume", text, names));
}

VolumeKind parse_volume(const CatalogScene& scene, const std::string& text) {
  return scene.dimension() == 2 ? parse_volume<2>(text) : parse_volume<3>(text);
}

Needs needs_of(const CatalogScene& scene) {
  return std::visit([](const auto* entry) { return entry->needs; }, scene.entry);
}

void check_growth(const CatalogScene& scene, const RenderTexts& texts) {
  const bool grows = std::visit([](const auto* entry) { return entry->grows; }, scene.entry);
  if (grows || (texts.grow.empty() && texts.recycle.empty())) return;
  throw UsageError((texts.grow.empty() ? "--recycle: " : "--grow: ") + scene.name +
                   " does not grow: all its objects are there from the first step; leave the option out");
}

BroadPhaseChoice parse_broad_phase(const CatalogScene& scene, const RenderTexts& texts) {
  BroadPhaseChoice choice = choose_broad_phase(
      texts.broad_phase.empty() ? kPaperTree : std::string_view(texts.broad_phase), needs_of(scene));
  if (!texts.config.empty() && !choice.is_tree())
    throw UsageError("--config: " + choice.name + " has no parameters; only kerf and kerf-paper do");
  choice.config = parse_config("--config", texts.config, choice.config);
  if (texts.volume.empty()) return choice;
  choice.volume = parse_volume(scene, texts.volume);
  if (choice.volume != VolumeKind::box && !takes_volumes(choice.name))
    throw UsageError("--volume: " + choice.name +
                     " knows only boxes; kerf, kerf-paper and brute-force take other volumes");
  return choice;
}

}  // namespace

RenderRequest parse_request(const RenderTexts& texts) {
  RenderRequest request;
  request.scene = find_scene(texts.scene);
  if (!texts.steps.empty()) request.steps = parse_steps(texts.steps);
  if (!texts.size.empty()) request.size = parse_picture_size(texts.size);
  if (!texts.objects.empty()) {
    request.options.objects = number_in("--objects", texts.objects, 1U, kMaxRequestedObjects);
  }
  if (!texts.grow.empty()) request.options.steps = number_in("--grow", texts.grow, 1U, kMaxStep);
  check_growth(request.scene, texts);
  if (!texts.recycle.empty()) request.options.recycle = number_in("--recycle", texts.recycle, 1U, kMaxStep);
  if (!texts.seed.empty()) {
    request.options.seed = number_in<std::uint64_t>("--seed", texts.seed, 0, UINT64_MAX);
  }
  if (!texts.fps.empty()) request.fps = number_in("--fps", texts.fps, 1, 240);
  if (!texts.show.empty())
    request.layers = parse_option("--show", [&] { return LayerSet::parse(texts.show); });
  check_camera(request.scene, texts.camera);
  request.camera = texts.camera;
  request.broad_phase = parse_broad_phase(request.scene, texts);
  request.out = texts.out.empty() ? std::filesystem::path("out") / request.scene.name
                                  : std::filesystem::path(texts.out);
  request.video = texts.video;
  if (!request.video.empty()) Video::check_extension(request.video);
  request.contact_sheet = texts.contact_sheet;
  if (!request.contact_sheet.empty()) check_picture_extension(request.contact_sheet);
  request.record = texts.record;
  request.overwrite = texts.overwrite;
  return request;
}

}  // namespace kerf
